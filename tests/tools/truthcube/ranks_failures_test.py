"""One rank of truthcube that cannot go on ends all: ranks_failures_test.py MPIRUN|none TRUTHCUBE CASE."""
import glob
import os
import pathlib
import re
import resource
import signal
import subprocess
import time

from ranks_runs import FOLDER, MPIRUN, SCENE, TRUTHCUBE, command, done, expect_same, record, run_and_remove
from ranks import ENVIRONMENT, SECONDS, run  # behind ranks_runs, which says where it is

MANY = [f"{0.001 * k:g}" for k in range(1, 300)]  # more steps than end before they are ended


def expect_no_process_left():
    """Of those that this test has started, whose environment says so."""
    mine = f"PHYSGEN_STARTED_BY={os.getpid()}".encode()
    until = time.monotonic() + SECONDS
    while True:
        left = []
        for entry in pathlib.Path("/proc").iterdir():
            try:
                is_mine = entry.name.isdigit() and mine in (entry / "environ").read_bytes().split(b"\0")
                if is_mine and (entry / "stat").read_text().rsplit(")", 1)[1].split()[0] != "Z":
                    left.append(entry.name)
            except OSError:
                continue
        if not left:
            return
        assert time.monotonic() < until, f"processes are left over: {left}"
        time.sleep(0.1)


def expect_end_of_all(said, found, output, errors):
    """With a status that is not 0, and the message of one rank, once."""
    assert found != 0 and len(re.findall(said, errors)) == 1, (found, output, errors)
    expect_no_process_left()


def started(*words):
    """A run of steps without end, which has written its first into the folder that is the last word."""
    process = subprocess.Popen((*words, "--compress", *MANY, "--out", str(FOLDER / "out")), env=ENVIRONMENT, text=True,
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    until = time.monotonic() + SECONDS
    while not (FOLDER / "out" / "checkpoint.h5").exists():
        assert time.monotonic() < until and process.poll() is None, process.communicate()
        time.sleep(0.02)
    return process


def rank_of(process, rank):
    """The number of the process that is this rank."""
    for entry in map(pathlib.Path, glob.glob("/proc/[0-9]*")):
        try:
            environment = (entry / "environ").read_bytes().split(b"\0")
            parent = (entry / "stat").read_text().rsplit(")", 1)[1].split()[1]
            if f"OMPI_COMM_WORLD_RANK={rank}".encode() in environment and parent == str(process.pid):
                return int(entry.name)
        except OSError:
            continue
    raise AssertionError("the rank has ended")


def expect_to_go_on():
    """The steps that are written are whole: the run is continued to the bits of one that was not interrupted."""
    out, again = FOLDER / "out", FOLDER / "again"
    steps = [f"{step['compression']:g}" for step in record(out)[0]["steps"]]
    output = done(0, *command(2, "--cells", "8", "--compress", *steps, "0.31", "--out", str(out), "--restart"))
    steps = steps[:int(re.search(r"continuing after step (\d+)", output).group(1))]
    done(0, TRUTHCUBE, *SCENE, "--cells", "8", "--compress", *steps, "0.31", "--out", str(again))
    expect_same(again, out, ("beads.csv", "checkpoint.h5"))


def a_full_disk_of_the_rank_that_writes_ends_all():
    """From a step on its files may not grow: it says how many bytes it needs, and all end with the steps before."""
    process = started(*command(2, "--cells", "8"))
    size = (FOLDER / "out" / "cube.vtkhdf").stat().st_size
    resource.prlimit(rank_of(process, 0), resource.RLIMIT_FSIZE, (size, size))
    _, errors = process.communicate(timeout=SECONDS)
    expect_end_of_all(r"rank 0 of 2 on \S+: \S+/cube.vtkhdf: needs \d+ bytes more", process.returncode, "", errors)
    expect_to_go_on()


def what_cannot_be_printed_is_said_once():
    """The first rank prints on a full disk: it says so, and all end."""
    script = 'if [ "$OMPI_COMM_WORLD_RANK" = 0 ]; then exec "$@" >/dev/full; fi; exec "$@"'
    words = (TRUTHCUBE, *SCENE, "--cells", "8", "--compress", "0.01")
    found, output, errors = run(MPIRUN, "--oversubscribe", "-n", "2", "bash", "-c", script, "bash", *words)
    assert not output, output
    expect_end_of_all("truthcube: cannot write all of the standard output; is the disk full[?]", found, output, errors)


def a_rank_whose_memory_ends_in_the_set_up_ends_all():
    """The second rank says in which stage. Nothing is written."""
    out = FOLDER / "out"
    words = command(2, "--cells", "48", "--volume", "tets", "--threads", "1", "--compress", "0.05", "--out", str(out))
    process = subprocess.Popen(words, env=ENVIRONMENT, text=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    until = time.monotonic() + SECONDS
    while not (out / "run.lock").exists():  # behind the forecast, which the limit must not meet
        assert time.monotonic() < until and process.poll() is None, process.communicate()
        time.sleep(0.001)
    number = rank_of(process, 1)

    def addresses():
        return int(re.search(r"VmSize:\s+(\d+) kB", pathlib.Path(f"/proc/{number}/status").read_text())[1]) << 10
    before = addresses()
    while addresses() < before + (4 << 20):
        assert time.monotonic() < until
    resource.prlimit(number, resource.RLIMIT_AS, (addresses(),) * 2)
    _, errors = process.communicate(timeout=SECONDS)
    expect_end_of_all(r'rank 1 of 2 on \S+: the memory ended in its stage "[a-z ]+": [^\n]*\d+ bytes', process.returncode, "", errors)
    assert {path.name for path in out.iterdir()} <= {"run.lock"}, list(out.iterdir())  # which nobody holds


def a_folder_that_another_run_holds_ends_all():
    """The first rank says which process holds it; the other run goes on, and behind it the folder is continued."""
    holder = started(TRUTHCUBE, *SCENE, "--cells", "8")
    for restart in ((), ("--restart",)):
        found, output, errors = run(*command(2, "--cells", "8", "--compress", "0.5", "--out", str(FOLDER / "out"), *restart))
        said = rf"rank 0 of 2 on \S+: \S+: another run writes there, process {holder.pid} on \S+ \(run.lock\): wait until it has ended"
        assert found != 0 and len(re.findall(said, errors)) == 1, (found, output, errors)
        assert holder.poll() is None, holder.communicate()
    holder.send_signal(signal.SIGINT)
    holder.communicate(timeout=SECONDS)
    assert holder.returncode == 130, holder.returncode
    expect_no_process_left()
    expect_to_go_on()


run_and_remove(globals())
