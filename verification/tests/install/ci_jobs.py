# SPDX-License-Identifier: Apache-2.0
"""Jobs of verification/conformance/ci, run as the two systems run them: each script as it stands, in order.

What a system itself does (checkout, caches, artifacts) is left out or has a stand-in. A condition of a step that is
not known here is an error, so that no script is passed over.
"""

import dataclasses
import os
import pathlib
import subprocess

import yaml

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
FOLDER = ROOT / "verification/conformance/ci"
TIME = 3000  # s, for one script; the slow test builds the program in one

# The conditions of steps, by: have all steps so far succeeded, outcome of each step by its id, is the program in the cache.
CONDITIONS = {
    None: lambda well, outcomes, is_cached: well,
    "steps.cache.outputs.cache-hit != 'true'": lambda well, outcomes, is_cached: well and not is_cached,
    "success() || steps.values.outcome == 'failure'":
        lambda well, outcomes, is_cached: well or outcomes.get("values") == "failure",
    "${{ !cancelled() }}": lambda well, outcomes, is_cached: True,
}


@dataclasses.dataclass
class Run:
    is_green: bool = True
    ran: list = dataclasses.field(default_factory=list)  # names of the steps, or first words of the lines
    said: str = ""  # stdout and stderr
    summary: str = ""  # Markdown
    kept: list = dataclasses.field(default_factory=list)  # files that are uploaded


def read(system):
    """Parses the file as YAML 1.1, in which GitHub's key `on` means true, and gives this key its name back."""
    job = yaml.safe_load((FOLDER / f"{system}.yml").read_text())
    return {"on" if key is True else key: value for key, value in job.items()}


def script(shell, text, folder, environment):
    return subprocess.run([*shell, text], cwd=folder, env=environment, stdin=subprocess.DEVNULL, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=TIME)


def run_github(folder, environment, is_cached=False):
    """A step in a container that names no shell is run by `sh -e`."""
    workflow, run, outcomes = read("github"), Run(), {}
    summary = folder.parent / f"{folder.name} summary.md"
    summary.write_text("")
    environment = {**environment, **{**workflow["env"], **environment}, "GITHUB_STEP_SUMMARY": str(summary)}
    for step in workflow["jobs"]["tribocheck"]["steps"]:
        if not CONDITIONS[step.get("if")](run.is_green, outcomes, is_cached):
            continue
        run.ran.append(step.get("name", step.get("uses")))
        if step.get("uses", "").startswith("actions/upload-artifact@"):
            run.kept = [name for name in step["with"]["path"].split() if (folder / name).exists()]
        if "run" in step:
            done = script(["sh", "-ec"], step["run"], folder, environment)
            run.said += done.stdout
            outcomes[step.get("id")] = "failure" if done.returncode else "success"
            run.is_green = run.is_green and done.returncode == 0
    run.summary = summary.read_text()
    return run


def run_gitlab(folder, environment):
    """The runner joins all lines to one bash script, which ends at the first line that fails."""
    job, run = read("gitlab")["tribocheck"], Run()
    lines = [*job["before_script"], *job["script"]]
    done = script(["bash", "-eo", "pipefail", "-c"], "\n".join(lines), folder, {**job["variables"], **environment})
    run.ran = [line.split()[0] for line in lines]
    run.said, run.is_green = done.stdout, done.returncode == 0
    artifacts = job["artifacts"]
    if run.is_green or artifacts["when"] == "always":
        run.kept = [name for name in artifacts["paths"] if (folder / name).exists()]
    run.summary = (folder / "summary.md").read_text() if "summary.md" in run.kept else ""
    return run
