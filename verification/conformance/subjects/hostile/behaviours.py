# SPDX-License-Identifier: Apache-2.0
"""The ways to break the protocol. Those per line take the right answer and the count of earlier bad lines."""

import json
import os
import signal
import sys
import time

MIB = 1 << 20
AT_START, PER_LINE = {}, {}


def at_start(function):
    AT_START[function.__name__] = function


def per_line(function):
    PER_LINE[function.__name__] = function


def say(text):
    print(text, flush=True)


def write(data):
    sys.stdout.flush()
    view = memoryview(data)
    while view:
        view = view[os.write(1, view):]


def sleep():
    while True:
        time.sleep(3600)


def with_numbers(right, token):
    """The answer with every number replaced by a token."""
    answer = json.loads(right)
    marked = {name: "@" if isinstance(value, float) else value for name, value in answer.items()}
    return json.dumps(marked).replace('"@"', token)


# Ends

@at_start
def exits_at_once():
    """exits with code 0 before it reads anything"""
    sys.exit(0)


@at_start
def exits_with_error():
    """writes a reason to stderr and exits with code 3 before it reads anything"""
    print("cannot open the licence file", file=sys.stderr)
    sys.exit(3)


@per_line
def exits(right, count):
    """exits with code 0, questions still open"""
    sys.exit(0)


@per_line
def dies_by_signal(right, count):
    """dies by SIGSEGV"""
    signal.signal(signal.SIGSEGV, signal.SIG_DFL)
    os.kill(os.getpid(), signal.SIGSEGV)


@per_line
def exits_within_a_line(right, count):
    """exits in the middle of an answer"""
    write(right[: len(right) // 2].encode())
    sys.exit(0)


# Silence

@per_line
def never_answers(right, count):
    """reads no further and never answers"""
    sleep()


@per_line
def half_a_line(right, count):
    """writes half an answer and waits for ever"""
    write(right[: len(right) // 2].encode())
    sleep()


@at_start
def closes_stdin():
    """closes stdin at once, but keeps running"""
    os.close(0)
    sleep()


@at_start
def closes_stdout():
    """closes stdout at once, but keeps running"""
    os.close(1)
    sleep()


@per_line
def ignores_sigterm(right, count):
    """ignores SIGTERM, SIGINT and SIGHUP, and never answers"""
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    sleep()


def leave_a_child(prepare):
    if os.fork() == 0:
        prepare()
        signal.alarm(60)  # an alarm is not inherited
        sleep()
    os._exit(0)


@per_line
def leaves_a_grandchild(right, count):
    """exits, but a child of its own keeps stdout open"""
    leave_a_child(lambda: None)


@per_line
def leaves_a_daemon(right, count):
    """exits, but a child in a session of its own keeps stdout open"""
    leave_a_child(os.setsid)


@per_line
def slow(right, count):
    """takes 0.2 s for each answer"""
    time.sleep(0.2)
    say(right)


# Floods

@per_line
def endless_line(right, count):
    """floods stdout with a line without an end"""
    while True:
        write(b"1" * MIB)


@per_line
def line_over_1_mib(right, count):
    """right answers behind 1 MiB of spaces"""
    say(" " * MIB + right)


@per_line
def unasked_answers(right, count):
    """floods stdout with well-formed answers that nobody asked for"""
    number = 0
    while True:
        write(b"".join(b'{"id": "unasked%d", "value": 1.0}\n' % (number + j) for j in range(1000)))
        number += 1000


@per_line
def floods_stderr(right, count):
    """writes 1 MiB to stderr before each answer"""
    sys.stderr.write("warning: something is odd\n" * (MIB // 26))
    say(right)


# Wrong lines

@per_line
def garbage(right, count):
    """lines that are not JSON"""
    say("Segmentation fault (just kidding)")


@per_line
def invalid_utf8(right, count):
    """answers with bytes that are not UTF-8"""
    write(right.encode()[:-1] + b', "text": "\xff\xfe\xc3"}\n')


@per_line
def zero_bytes(right, count):
    """answers with bytes of value 0 in them"""
    write(right.encode().replace(b", ", b",\0") + b"\n")


@per_line
def deeply_nested(right, count):
    """100 000 brackets that open"""
    say("[" * 100000)


@per_line
def wrong_id(right, count):
    """answers with another id"""
    say(json.dumps({**json.loads(right), "id": f"other{count}"}))


@per_line
def without_id(right, count):
    """answers without an id"""
    say(json.dumps({name: value for name, value in json.loads(right).items() if name != "id"}))


@per_line
def duplicate_answers(right, count):
    """gives each answer twice"""
    say(right)
    say(right)


@per_line
def missing_answers(right, count):
    """leaves out every third answer"""
    if count % 3 != 0:
        say(right)


held_back = []


@per_line
def out_of_order(right, count):
    """gives the answers of each two questions in the other order"""
    held_back.append(right)
    if len(held_back) == 2:
        say(held_back.pop())
        say(held_back.pop())


# Wrong values

def value_behaviour(name, token, description):
    def misbehave(right, count):
        say(with_numbers(right, token))
    misbehave.__name__, misbehave.__doc__ = name, description
    per_line(misbehave)


value_behaviour("answers_nan", "NaN", "NaN in place of numbers")
value_behaviour("answers_infinity", "Infinity", "Infinity in place of numbers")
value_behaviour("answers_1e999", "1e999", "1e999 in place of numbers, which no double holds")
value_behaviour("answers_strings", '"1.0"', "texts in place of numbers")
value_behaviour("answers_objects", '{"value": 1.0, "unit": "m"}', "objects in place of numbers")
value_behaviour("answers_lists", "[1.0]", "lists in place of numbers")
value_behaviour("answers_null", "null", "null in place of numbers, without a reason")
value_behaviour("answers_true", "true", "true in place of numbers")


@per_line
def answers_nothing(right, count):
    """answers with nothing but the id"""
    say(json.dumps({"id": json.loads(right)["id"]}))
