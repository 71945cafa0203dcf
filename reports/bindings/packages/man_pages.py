#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes man pages and the completion for bash from the program's --help: man_pages.py PROGRAM FOLDER.

FOLDER gets man/man*/*.gz and completions/tribocheck. A new command, option or function is in them without a change
of this script. SOURCE_DATE_EPOCH in the environment sets the date of the pages.
"""
import argparse
import gzip
import json
import os
import pathlib
import re
import shlex
import subprocess
import time

COLUMN = 34  # where the help's descriptions of options begin
SOURCES = pathlib.Path(__file__).resolve().parents[3]
DATE = time.strftime("%F", time.gmtime(int(os.environ.get("SOURCE_DATE_EPOCH", time.time()))))


def roff(text):
    text = text.replace("\\", "\\(rs").replace("-", "\\-")
    return "\\&" + text if text[:1] in (".", "'") else text


def body(lines):
    """The lines in roff. Prose is filled. Indented lines stay as they are; their indent is small, so that they fit in 80 columns."""
    out, is_kept = [], False
    for line in lines:
        if line and line.startswith(" ") != is_kept:
            out += [".fi", ".in"] if is_kept else [".PP", ".in 2n", ".nf"]
            is_kept = not is_kept
        out.append(roff(line.removeprefix("  ")) if line else ".PP" if not is_kept else "")
    return out + ([".fi", ".in"] if is_kept else [])


class Help:
    """The help of one command: its meaning, its usage, sections of entries, the text below them, and examples."""

    def __init__(self, program, command):
        self.command = command
        text = subprocess.run([program, *command, "--help"], cwd=SOURCES, stdout=subprocess.PIPE, text=True, check=True).stdout
        text = text.replace("reference/", "/usr/share/tribocheck/")  # where the package installs these files
        head, _, text = text.strip().partition("\nUsage: ")
        self.meaning = head.strip()
        self.usage, _, text = text.partition("\n")
        self.sections, lines = {}, text.splitlines()
        while lines and (not lines[0] or (re.fullmatch(r"[A-Z]\w+:", lines[0]) and lines[0] != "Example:")):
            title = lines.pop(0)
            if not title:
                continue
            entries = self.sections[title.rstrip(":")] = []
            while lines and lines[0].startswith("  "):
                line = lines.pop(0)
                head, words = line[:COLUMN], line[COLUMN:]
                if line[COLUMN - 1:COLUMN].strip():  # a long entry, whose description is on the next line
                    head, words = line, ""
                if head.strip():
                    entries.append((head.strip(), []))
                entries[-1][1].append(words)
        split = lines.index("Example:") if "Example:" in lines else len(lines)
        self.text, self.examples = lines[:split], lines[split + 1:]

    def subcommands(self):
        return [head for head, _ in self.sections.get("Subcommands", [])]

    def options(self):
        """{option: the words that it takes}; positional arguments are under ""."""
        found = {"": []}
        for title, entries in self.sections.items():
            for head, _ in entries if title != "Subcommands" else []:
                listed = re.search(r"\{(.*?)\}", head)
                words = listed[1].split(",") if listed else []
                names = re.findall(r"(?<!\S)--?[\w-]+", head.split(" ")[0].replace(",", " "))
                for name in names or [""]:
                    found[name] = words
        return found


def header(name, section, meaning):
    return [f'.TH {name.upper()} {section} "{DATE}" "tribocheck" ' + ('"User Commands"' if section == 1 else '"Functions"'),
            ".nh", ".ad l", ".SH NAME", f"{name} \\- {roff(meaning)}"]


def command_page(help_of, others):
    """The page of a command."""
    out = header("-".join(["tribocheck", *help_of.command]), 1, help_of.meaning)
    out += [".SH SYNOPSIS", roff(help_of.usage)]
    if help_of.text:
        out += [".SH DESCRIPTION", *body(help_of.text)]
    for title, entries in help_of.sections.items():
        out.append(f".SH {'ARGUMENTS' if title == 'Positionals' else 'COMMANDS' if title == 'Subcommands' else title.upper()}")
        for head, words in entries:
            name, _, rest = head.partition(" ")
            rest = re.sub(r"\b(\w+):(?=\1 in|\{)", "", rest)
            out += [".TP", f"\\fB{roff(name.replace(',', ', '))}\\fR {roff(rest)}".rstrip(), roff(" ".join(words).strip())]
    if help_of.examples:
        out += [".SH EXAMPLES", *body(help_of.examples)]
    return out + [".SH SEE ALSO", *(f".BR {roff(other)} (1)," for other in others), ".BR tribocheck\\-functions (7)"]


def functions_page(functions):
    """The page of all functions of the catalogue."""
    out = header("tribocheck-functions", 7, "functions that tribocheck answers, with units, ranges and sources")
    out += [".SH DESCRIPTION", "A function is asked by a line of JSON to", ".BR tribocheck\\-stream (1),",
            "by its name in the package of Python, and by", ".B tribocheck_call()", "in C. All numbers are in SI units.", ".SH FUNCTIONS"]
    for one in functions:
        out += [f".SS {roff(one['name'])}", roff(one["meaning"][0].upper() + one["meaning"][1:]) + ".", ".PP", roff(one["equation"])]
        for title, rows in (("Arguments", one["parameters"]), ("Results", one["results"])):
            out += [".PP", f"{title}:"]
            for row in rows:
                unit = f" [{row['unit'] or '-'}]"
                allowed = f"; allowed: {row['allowed']}" if row.get("allowed") else ""
                out += [".TP", f"\\fB{roff(row['name'])}\\fR{roff(unit)}", roff(row["meaning"] + allowed)]
        out += [".PP", roff(f"Source: {one['source']}")]
    return out + [".SH SEE ALSO", ".BR tribocheck\\-functions (1),", ".BR tribocheck\\-stream (1),", ".BR tribocheck\\-verify (1)"]


def completion(pages):
    """The script for bash. It completes commands, options, words of an option and names of functions, else names of files."""
    def words(names):
        return "(" + " ".join(shlex.quote(name) for name in names) + ")"
    by_option, by_command = [], []
    for page in pages:
        command = " ".join(page.command)
        options = page.options()
        by_command.append(f"    {shlex.quote(command)}) options={words(name for name in options if name)}"
                          f" words={words(page.subcommands() + options[''])} ;;")
        by_option += [f"    {shlex.quote(f'{command} {name}')}) values={words(taken)} ;;" for name, taken in options.items() if name and taken]
    joined = "|".join(shlex.quote(" ".join(page.command)) for page in pages if len(page.command) > 1)
    return "\n".join([
        "# bash completion of tribocheck", "_tribocheck() {",
        "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command= word",
        "  local -a options=() words=() values=()",
        "  [ \"$current\" = = ] && current=",
        "  [ \"$previous\" = = ] && previous=${COMP_WORDS[COMP_CWORD-2]}",
        "  [ \"$COMP_CWORD\" -gt 1 ] && command=${COMP_WORDS[1]}",
        f"  [ \"$COMP_CWORD\" -gt 2 ] && case \"$command ${{COMP_WORDS[2]}}\" in {joined}) command+=\" ${{COMP_WORDS[2]}}\" ;; esac",
        "  case $command in", *by_command, "  esac",
        "  case \"$command $previous\" in", *by_option,
        "    *) case $current in -*) values=(\"${options[@]}\") ;; *) values=(\"${words[@]}\") ;; esac",
        "       [ \"$command\" = functions ] && [[ $current != -* ]] && values=($(\"$1\" functions 2>/dev/null | cut -d ' ' -f 1)) ;;",
        "  esac",
        "  COMPREPLY=()",
        "  for word in \"${values[@]}\"; do",
        "    [[ $word == \"$current\"* ]] && COMPREPLY+=(\"$(printf %q \"$word\")\")",
        "  done",
        "}", "complete -o default -F _tribocheck tribocheck", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("folder", type=pathlib.Path)
    given = parser.parse_args()
    pages, commands = [], [[]]
    for command in commands:
        pages.append(Help(given.program, command))
        commands += [[*command, name] for name in pages[-1].subcommands()]
    names = ["-".join(["tribocheck", *page.command]) for page in pages]
    functions = json.loads(subprocess.run([given.program, "functions", "--format", "json"], stdout=subprocess.PIPE, check=True).stdout)
    texts = {f"{name}.1": command_page(page, [other for other in names if other != name]) for name, page in zip(names, pages)}
    texts["tribocheck-functions.7"] = functions_page(functions["functions"])
    texts["tribocheck_sweep.1"] = [".so man1/tribocheck-sweep.1"]  # the program that `tribocheck sweep` runs
    for folder in ("man/man1", "man/man7", "completions"):
        (given.folder / folder).mkdir(parents=True, exist_ok=True)
    for name, lines in texts.items():
        (given.folder / f"man/man{name[-1]}/{name}.gz").write_bytes(gzip.compress(("\n".join(lines) + "\n").encode(), 9, mtime=0))
    (given.folder / "completions/tribocheck").write_text(completion(pages), encoding="utf-8")


if __name__ == "__main__":
    main()
