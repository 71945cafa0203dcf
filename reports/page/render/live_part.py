# SPDX-License-Identifier: Apache-2.0
"""The page's live part: the model as WebAssembly, its script and its style (reports/live), and the scenes to start from."""
import base64
import gzip
import json
import pathlib
import tomllib

HERE = pathlib.Path(__file__).resolve().parent.parent.parent / "live"


def scenes(out):
    """The texts of the report's scenes by their names, in the order in which the page offers them."""
    return {path.stem: path.read_text(encoding="utf-8") for path in sorted((out / "data/scenes").glob("*.toml"))}


def mistakes():
    """The mistakes of reference/mistakes.toml that only change arguments or results of a function by numbers. The page can make these."""
    places = (HERE.parent.parent / "reference/mistakes.toml", HERE.parent / "mistakes.toml")  # of the sources, of an installed program
    path = next((one for one in places if one.is_file()), None)
    known = tomllib.loads(path.read_text(encoding="utf-8"))["mistake"] if path else []
    return [{"functions": one["function"] if isinstance(one["function"], list) else [one["function"]], "name": one["name"], "text": one["text"],
             "input": one.get("input", {}), "result": one.get("result", {})}
            for one in known if set(one) <= {"function", "name", "text", "input", "result", "follows"}
            and all(set(change) <= {"times", "is", "inverted"} for change in one.get("input", {}).values())
            and all(set(change) <= {"times", "over"} for change in one.get("result", {}).values())]


def parts(out):
    """The style to append to the page's own, and the elements for the page's end; both empty if reports/live has no tribocheck.wasm."""
    if not (HERE / "tribocheck.wasm").is_file():
        return "", ""
    # Base 85 takes a sixteenth less room than base 64. None of its signs ends a script.
    model = base64.b85encode(gzip.compress((HERE / "tribocheck.wasm").read_bytes(), 9, mtime=0)).decode()
    told = json.dumps({"scenes": scenes(out), "mistakes": mistakes(), "form": json.loads((HERE / "form.json").read_text(encoding="utf-8"))}, ensure_ascii=False, separators=(",", ":")).replace("</", "<\\/").replace("<!--", "<\\!--")
    # The page has a limit of bytes: the comments of the script stay in its source.
    script = "".join(line for line in (HERE / "live.js").read_text(encoding="utf-8").splitlines(keepends=True)
                     if "SPDX" in line or not line.lstrip().startswith("//"))
    return ((HERE / "live.css").read_text(encoding="utf-8"),
            f'<script type="text/plain" id="live-wasm">{model}</script>\n'
            f'<script type="application/json" id="live-data">{told}</script>\n<script>\n{script}</script>\n')
