# SPDX-License-Identifier: Apache-2.0
"""Numbers of the page as text. A float is never printed without saying how many digits are known."""
import math

SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
NO_ENTRY = "–"


def exact(value):
    """A text that reads back to the same double; NaN for an undefined number, which may be None."""
    return "NaN" if value is None or math.isnan(value) else repr(float(value)).removesuffix(".0")


def rounded(value, digits):
    """`digits` significant digits; −1.8 × 10⁻¹⁰ where the plain number would be long; – where there is no number."""
    if value is None or not math.isfinite(value):
        return NO_ENTRY
    if value < 0:
        return "−" + rounded(-value, digits)
    if value == 0:
        return "0"
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    power = int(exponent)
    if -4 <= power < 6:
        return (f"{value:.{digits - 1 - power}f}" if power < digits
                else grouped(int(float(f"{mantissa}e{exponent}"))))
    return f"{mantissa} × 10{str(power).translate(SUPERSCRIPTS)}"


def unrounded(value):
    """The number with as many digits as it takes to read back the same double."""
    if value is None or not math.isfinite(value):
        return NO_ENTRY
    return rounded(value, next(digits for digits in range(1, 18) if float(f"{value:.{digits - 1}e}") == value))


def grouped(count):
    """12345678 as 12 345 678, with narrow blanks that do not break."""
    return f"{count:,}".replace(",", "\u202f") if count > 9999 else str(count)


def percent(part, digits=3):
    """A part as per cent. Only 0 and 1 are 0 % and 100 %: a part near them is < 0.1 %, > 99.9 % or > 100 %."""
    if part is None or not math.isfinite(part):
        return NO_ENTRY
    if part in (0, 1):
        return f"{100 * part:g} %"
    if 0 < part < 0.001:
        return "< 0.1 %"
    text = rounded(100 * part, digits)
    if text == rounded(100, digits):
        text = "> 100" if part > 1 else "> " + rounded(100 - 10**(2 - digits), digits)
    return text + " %"


def interval(values, digits):
    """1.06 to 3.66; one number where both ends print alike."""
    low, high = (rounded(value, digits) for value in (min(values), max(values)))
    return low if low == high else f"{low} to {high}"
