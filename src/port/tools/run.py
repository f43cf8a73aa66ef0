"""Runs other programs for the tools here: what is missing or fails becomes one sentence for the user."""
import shutil
import subprocess

from boards import Failure


def require(tool, what, package=None):
    """The path of a program without which `what` is not possible."""
    path = shutil.which(tool)
    if path is None:
        raise Failure(f"{what} needs {tool}, which is not installed: "
                      + (f"install the package {package}" if package else "`.ci/install firmware` installs it"))
    return path


def attempt(command):
    """(exit code, output with errors) of a command."""
    run = subprocess.run([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, text=True, errors="replace")
    return run.returncode, run.stdout


def execute(command, what):
    """The output of a command that must succeed."""
    words = [str(word) for word in command]
    require(words[0], what)
    code, output = attempt(words)
    if code != 0:
        raise Failure(f"{what} failed: {' '.join(words)} ended with exit code {code}:\n{output}")
    return output
