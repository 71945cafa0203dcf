#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Asks the solvers of solvers.toml and keeps the verdicts. Each solver runs under bubblewrap, without network, and may write only to /tmp.

A solver's repository is cloned into build/field/sources or the folder of --clones. With --sources nothing is cloned: that folder has a
checkout for each solver, named by its id. The pinned commit is checked out. The adapter finds the checkout by FIELD_SOURCE. The program
writes ID.json, the verdict, and ID.toml, who was asked and how. If a verdict of another day differs, its files are renamed ID_DATE.json and .toml.
Exit code 1: a solver gave no verdict; 2: bad input, or no bubblewrap.

  reports/field/run.py
  reports/field/run.py --only stdlib --out verdicts
"""
import argparse
import datetime
import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILT = "build/release/verification/conformance/subjects"
KEPT = ("name", "language", "licence", "conventions", "commit")


def fail(text, code=2):
    print(f"field: {text}", file=sys.stderr)
    sys.exit(code)


def sandbox(source):
    """The command before a program that runs it in a sandbox: it can read only programs, this project and the source, write only to /tmp,
    and has no network."""
    links = [part for name in ("bin", "lib", "lib64", "sbin") for part in ("--symlink", f"usr/{name}", f"/{name}")]
    own = [part for name in ("/etc/alternatives", "/etc/ld.so.cache") for part in ("--ro-bind-try", name, name)]
    return ["bwrap", "--unshare-all", "--die-with-parent", "--new-session", "--ro-bind", "/usr", "/usr", *links, *own,
            "--proc", "/proc", "--dev", "/dev", "--tmpfs", "/tmp", "--ro-bind", ROOT, ROOT,
            *(["--ro-bind", source, "/source"] if source else []), "--chdir", ROOT, "--clearenv", "--setenv", "PATH", "/usr/bin",
            "--setenv", "HOME", "/tmp", "--setenv", "FIELD_SOURCE", "/source", "--"]


def checkout(solver, sources, clones):
    """The folder of the solver's pinned source; None where it has no repository."""
    if "repository" not in solver:
        return None
    folder = (sources or clones) / solver["id"]
    if not folder.is_dir():
        if sources:
            fail(f"{folder}: it is missing; allowed with --sources: a checkout of {solver['repository']} at {solver['commit']}")
        folder.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(["git", "clone", "-q", "--no-checkout", solver["repository"], folder], check=True)
    if (folder / ".git").exists():
        git = ["git", "-C", folder]
        if subprocess.run([*git, "cat-file", "-e", solver["commit"]], stderr=subprocess.DEVNULL).returncode:
            subprocess.run([*git, "fetch", "-q"], check=True)  # the commit is newer than the clone
        subprocess.run([*git, "checkout", "-q", solver["commit"]], check=True)
    return folder.resolve()


def ask(solver, source):
    """The verdict as JSON text, which is empty if there is none, and the command as a reader would type it."""
    way = "--plugin" if "plugin" in solver else "--subject"
    asked = solver[way[2:]].format(field="reports/field", subjects=BUILT, conformance="verification/conformance/subjects")
    options = [way, asked, *solver.get("options", [])]
    done = subprocess.run([*sandbox(source), "build/release/tribocheck", "verify", *options, "--format", "json"],
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True)
    shown = f"tribocheck verify {shlex.join(options)}"
    return done.stdout if done.returncode in (0, 1) else "", f"FIELD_SOURCE=CHECKOUT {shown}" if source else shown


def keep(out, solver, verdict, asked):
    """Writes both files. Older files are renamed first, if they are of another day and a quantity has another status in them."""
    path = out / f"{solver['id']}.json"
    said = json.loads(verdict)
    about = {key: solver[key] for key in KEPT if key in solver} | {
        "date": datetime.date.today().isoformat(), "asked": asked, "group": solver["kind"]}
    about.setdefault("licence", "none stated" if "repository" in solver else "Apache-2.0")  # this project's licence
    if solver.get("repository", "").startswith("http"):
        about["address"] = solver["repository"]
    if path.exists():
        before = tomllib.loads(path.with_suffix(".toml").read_text(encoding="utf-8"))["date"]
        old = json.loads(path.read_text(encoding="utf-8"))
        if before != about["date"] and [one["status"] for one in old["quantities"]] != [one["status"] for one in said["quantities"]]:
            for file in (path, path.with_suffix(".toml")):
                file.rename(file.with_stem(f"{path.stem}_{before}"))
    said["last_errors"] = []  # they quote the solver's text and this machine's folders
    path.write_text(json.dumps(said, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    lines = [f"{key} = {json.dumps(value, ensure_ascii=False)}\n" for key, value in about.items()]  # these JSON strings are TOML strings too
    path.with_suffix(".toml").write_text("".join(lines), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--solvers", type=pathlib.Path, default=ROOT / "reports/field/solvers.toml", metavar="FILE")
    parser.add_argument("--sources", type=pathlib.Path, metavar="DIR")
    parser.add_argument("--clones", type=pathlib.Path, default=ROOT / "build/field/sources", metavar="DIR")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "reference/field", metavar="DIR")
    parser.add_argument("--only", action="append", default=[], metavar="ID")
    given = parser.parse_args()
    solvers = tomllib.loads(given.solvers.read_text(encoding="utf-8"))["solver"]
    for name in given.only:
        if name not in [one["id"] for one in solvers]:
            fail(f"--only: {name} is not one of {', '.join(one['id'] for one in solvers)}")
    if not shutil.which("bwrap") or subprocess.run([*sandbox(None), "true"], stderr=subprocess.DEVNULL).returncode:
        fail("bubblewrap is missing or may not make a sandbox here; code of others runs in one alone (Debian: apt-get install bubblewrap)")
    given.out.mkdir(parents=True, exist_ok=True)
    silent = []
    for solver in (one for one in solvers if not given.only or one["id"] in given.only):
        try:
            verdict, asked = ask(solver, checkout(solver, given.sources, given.clones))
        except subprocess.CalledProcessError as error:
            verdict = ""
            print(f"field: {shlex.join(map(str, error.cmd))} failed", file=sys.stderr)
        if verdict:
            keep(given.out, solver, verdict, asked)
        else:
            silent.append(solver["id"])
        print(f"{solver['id']}: {json.loads(verdict)['summary'] if verdict else 'no verdict; it needs ' + (', '.join(solver.get('needs', [])) or 'nothing')}", flush=True)
    if silent:
        fail(f"no verdict of {', '.join(silent)}", 1)


if __name__ == "__main__":
    main()
