"""truthcube on several ranks: ranks_test.py MPIRUN|none TRUTHCUBE CASE."""
import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import time

from ranks_runs import FOLDER, MPIRUN, SCENE, TRUTHCUBE, command, done, expect_same, record, run_and_remove, without_times
from ranks import ENVIRONMENT, SECONDS, run  # behind ranks_runs, which says where it is


def several_ranks_write_the_files_of_one_process():
    """Files are equal byte for byte, and what is printed but for times, with one rank too; run.json says what has crossed. Of 24^3 cells the
    mesh of 12^3 is cut, too."""
    for volume, poisson, cells, counts in (("patches", "0.49", "16", (1, 4)), ("tets", "0.45", "24", (3,))):
        words = ("--cells", cells, "--volume", volume, "--poisson", poisson, "--compress", "0.05", "0.1", "--out")
        wanted = FOLDER / volume
        printed = without_times(done(0, TRUTHCUBE, *SCENE, *words, str(wanted)))
        assert len(record(wanted)[0]["steps"]) == 2 and any(line["coarser_by"] for line in record(wanted)[0]["steps"][0]["newton"])
        assert "estimated from half as many cells" in "\n".join(printed)
        for count in counts:
            found = FOLDER / f"{volume}_{count}"
            cut = ("--replicate", "1000") if count > 1 else ()
            assert without_times(done(0, *command(count, *cut, *words, str(found)))) == printed, f"{count} ranks"
            expect_same(wanted, found)
            ranks = record(found)[1]
            print(volume, count, ranks)
            if count == 1:
                assert ranks is None, ranks
                continue
            iterations = sum(line["pcg_iterations"] for step in record(found)[0]["steps"] for line in step["newton"] if line["coarser_by"] == 0)
            assert ranks["count"] == count and ranks["exchanges"] > 6 * iterations and ranks["gathers"] > 3 * iterations, (iterations, ranks)
            assert min(ranks["messages"], ranks["bytes"], ranks["gathered_bytes"]) > 0, ranks


def a_restart_on_any_number_of_ranks_has_the_same_bits():
    """A run that was begun on four ranks is continued on one and on three, as if it had not ended."""
    words = ("--cells", "16")
    wanted = FOLDER / "wanted"
    done(0, TRUTHCUBE, *SCENE, *words, "--compress", "0.05", "0.1", "--out", str(wanted))
    begun = FOLDER / "begun"
    done(0, *command(4, *words, "--compress", "0.05", "--out", str(begun)))
    assert len(record(begun)[0]["steps"]) == 1
    for count in (1, 3):
        found = FOLDER / f"on_{count}"
        shutil.copytree(begun, found)
        words_again = (*words, "--compress", "0.05", "0.1", "--out", str(found), "--restart")
        output = done(0, *(command(count, *words_again) if count > 1 else (TRUTHCUBE, *SCENE, *words_again)))
        assert output.count("continuing after step 1") == 1, output
        expect_same(wanted, found)
        assert "nothing is left to do" in done(0, *command(2, *words_again))


def what_several_ranks_do_not_have_is_refused():
    """One sentence with a remedy, once, before anything is made or written."""
    out = FOLDER / "refused"
    for status, words, said in (
            (1, ("--scene", "linear-elastic", "--preconditioner", "schwarz"), "do not have --scene linear-elastic --preconditioner schwarz; take --preconditioner "),
            (1, ("--scene", "implicit-dynamics", "--precision", "double"), "do not have --scene implicit-dynamics with the arrays of the scene everything; take the cube, of stable"),
            (None, ("--scene", "linear-elastic", "--device", "cuda"), "do not have --scene linear-elastic on CUDA; write --scene quasistatic|no device cuda. This build has cpu"),
            (None, ("--scene", "implicit-dynamics", "--device", "cuda"), "do not have --scene implicit-dynamics on CUDA; write --scene quasistatic|no device cuda. This build has cpu"),
            (None, ("--scene", "explicit-dynamics", "--device", "cuda"), "do not have --scene explicit-dynamics on CUDA; write --scene quasistatic|no device cuda. This build has cpu"),
            (None, ("--scene", "matrix-free", "--device", "cuda"), "do not have --scene matrix-free on CUDA; write --scene quasistatic|no device cuda. This build has cpu"),
            (2, ("--scene", "quasistatic", "--plates", "contact"), "requires --plates held"),
            (2, ("--scene", "quasistatic", "--preconditioner", "schwarz"), "cannot take --preconditioner schwarz"),
            (2, ("--scene", "quasistatic", "--cels", "3"), "--cels")):
        found, output, errors = run(MPIRUN, "--oversubscribe", "-n", "2", TRUTHCUBE, *words, "--out", str(out))
        assert found == (status or found) != 0 and not output and not out.exists(), (words, found, output, errors)
        assert len(re.findall(said, errors)) == 1, (words, errors)
    for cells in ("2", "3"):  # whose one level multigrid inverts
        found, _, errors = run(*command(2, "--cells", cells, "--compress", "0.1", "--out", str(out)))
        assert found == 1 and len(re.findall("several ranks do not have multigrid over one level of at most 125 nodes, which is inverted as a whole; take more cells or another preconditioner, or solve in one process", errors)) == 1, (found, errors)
        assert not any(out.iterdir()), list(out.iterdir())


def ranks_with_other_options_are_refused():
    """Options are those of all ranks; both are said, also where one rank alone would refuse its own, or print its help."""
    words = (TRUTHCUBE, *SCENE, "--compress", "0.05", "--cells", "8")
    for other in (("--cells", "10"), ("--cels", "10"), ("--help",)):
        found, output, errors = run(MPIRUN, "--oversubscribe", "-n", "1", *words, ":", "-n", "1", TRUTHCUBE, *SCENE, *other)
        assert found == 1 and not output, (found, output, errors)
        said = re.findall(r"rank 0 of 2 on \S+: rank 1 on \S+ has another command: \"([^\"]*)\", and rank 0 has \"([^\"]*)\"; start", errors)
        assert len(said) == 1 and said[0][0].endswith(" ".join(other)) and said[0][1].endswith("--cells 8"), errors


def ranks_that_read_other_checkpoints_are_refused():
    """As where machines have folders of their own: also where nothing is left to do on one rank, and where positions hardly differ."""
    for name, steps in (("one", ("0.05",)), ("two", ("0.05", "0.1")), ("near", ("0.0500000001",))):
        done(0, TRUTHCUBE, *SCENE, "--cells", "8", "--compress", *steps, "--out", str(FOLDER / name / "out"))
    restart = (TRUTHCUBE, *SCENE, "--cells", "8", "--compress", "0.05", "0.1", "--out", "out", "--restart")
    for other, said in (("two", "step 2, at 0.1"), ("near", "step 1, at 0.05")):
        words = [("-n", "1", "-wdir", str(FOLDER / name), *restart) for name in ("one", other)]
        found, output, errors = run(MPIRUN, "--oversubscribe", *words[0], ":", *words[1])
        assert found == 1 and "compression 0.1" not in output, (found, output, errors)
        both = rf'rank 1 on \S+ has another checkpoint in out: "{said}[^"]*", and rank 0 has "step 1, at 0.05'
        assert len(re.findall(both, errors)) == 1, errors


def a_program_that_no_launcher_started_does_not_begin_mpi():
    """Started by itself it is one process, which never calls MPI_Init, and prints nothing of ranks."""
    guard = FOLDER / "guard.so"
    (FOLDER / "guard.c").write_text("#include <stdlib.h>\nint MPI_Init_thread(int *a, char ***b, int c, int *d) { abort(); }\n")
    subprocess.run(["cc", "-shared", "-fPIC", "-o", str(guard), str(FOLDER / "guard.c")], check=True)
    environment = {key: word for key, word in ENVIRONMENT.items() if not key.startswith(("OMPI_", "PMIX_", "SLURM_"))}
    words = (TRUTHCUBE, *SCENE, "--cells", "4", "--compress", "0.05")
    alone = subprocess.run(words, env={**environment, "LD_PRELOAD": str(guard)}, capture_output=True, text=True, timeout=SECONDS, check=False)
    assert alone.returncode == 0 and "rank" not in alone.stdout + alone.stderr, alone
    begun = subprocess.run(words, env={**environment, "LD_PRELOAD": str(guard), "PMIX_RANK": "0"}, capture_output=True, timeout=SECONDS, check=False)
    assert begun.returncode != 0, "the guard does not work"


def started(*words, environment=None):
    """A run of four ranks that takes long, once it has written its first step."""
    out = FOLDER / "long"
    shutil.rmtree(out, ignore_errors=True)
    many = [f"{0.001 * k:g}" for k in range(1, 200)]
    process = subprocess.Popen(command(4, "--cells", "16", "--compress", *many, "--out", str(out), *words),
                               env={**ENVIRONMENT, **(environment or {})}, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    until = time.monotonic() + SECONDS
    while not (out / "checkpoint.h5").exists():
        assert time.monotonic() < until and process.poll() is None, process.communicate()
        time.sleep(0.05)
    return process, out


def ranks_of(process):
    """Processes of ranks, by the number of the rank."""
    found = {}
    for entry in pathlib.Path("/proc").iterdir():
        try:
            environment = (entry / "environ").read_bytes().split(b"\0")
            if (entry / "stat").read_text().rsplit(")", 1)[1].split()[1] != str(process.pid):
                continue
            found.update({int(word.split(b"=")[1]): int(entry.name) for word in environment if word.startswith(b"OMPI_COMM_WORLD_RANK=")})
        except (OSError, IndexError):
            continue
    assert sorted(found) == [0, 1, 2, 3], found
    return found


def is_alive(pid):
    """Whether a process has not ended."""
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


def drawn(out):
    """What cube.vtkhdf holds, by name; nothing where h5py is missing."""
    try:
        import h5py
    except ImportError:
        return print("cube.vtkhdf is not compared: there is no python3-h5py")
    found = {}
    with h5py.File(out / "cube.vtkhdf") as file:
        file.visititems(lambda name, item: found.update({name: (dict(item.attrs), item[()].tobytes() if isinstance(item, h5py.Dataset) else b"")}))
    return {name: (str(attributes), values) for name, (attributes, values) in found.items()}


def expect_whole_files(out):
    """A run goes on behind the last step that is whole, to the bits of one that was not interrupted. A file for viewers whose write was
    interrupted has room besides that nothing uses."""
    steps = [step["compression"] for step in json.loads((out / "run.json").read_text())["steps"]]
    more = f"{steps[-1] + 0.005:g}"
    output = done(0, *command(2, "--cells", "16", "--compress", more, "--out", str(out), "--restart"))
    steps = steps[:int(re.search(r"continuing after step (\d+)", output).group(1))]
    again = FOLDER / "again"
    shutil.rmtree(again, ignore_errors=True)
    done(0, TRUTHCUBE, *SCENE, "--cells", "16", "--compress", *[f"{step:g}" for step in steps], more, "--out", str(again))
    expect_same(again, out, ("beads.csv", "checkpoint.h5"))
    wanted = drawn(again)
    assert wanted is None or len(wanted) > 10 and wanted == drawn(out), "cube.vtkhdf"


def an_interrupt_of_one_rank_ends_all_behind_a_step():
    """All ranks learn of it, and end with the status of an interrupted run; files are whole."""
    process, out = started()
    os.kill(ranks_of(process)[2], signal.SIGINT)
    output, errors = process.communicate(timeout=SECONDS)
    assert process.returncode == 130 and len(re.findall(r"^interrupted; \d+ steps are written$", output, re.M)) == 1, (process.returncode, output, errors)
    expect_whole_files(out)


def expect_end(process, killed):
    """Kills a rank: all others end within 30 seconds, with a status that is not 0, and the rank is named."""
    ranks = ranks_of(process)
    os.kill(ranks[killed], signal.SIGKILL)
    _, errors = process.communicate(timeout=30)
    assert process.returncode != 0 and re.search(rf"process rank {killed} with PID \d+ on node", errors), (process.returncode, errors)
    until = time.monotonic() + SECONDS
    while any(map(is_alive, ranks.values())):
        assert time.monotonic() < until, "a rank is left over"
        time.sleep(0.1)


def a_killed_rank_ends_all():
    """In a solve; files are whole."""
    process, out = started()
    expect_end(process, 1)
    expect_whole_files(out)


# Rank 0 stops before a call that changes a file of its run, counted from the first step on.
STOPS = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
static void count(const char* path) {
  static int calls = 0;
  const char *rank = getenv("OMPI_COMM_WORLD_RANK"), *folder = getenv("STOP_IN");
  char file[4200];
  if (!rank || strcmp(rank, "0") || strncmp(path, folder, strlen(folder))) return;
  snprintf(file, sizeof file, "%s/checkpoint.h5", folder);
  if (access(file, F_OK) || calls++ != atoi(getenv("STOP_AT"))) return;
  snprintf(file, sizeof file, "%s.stopped", folder);
  close(creat(file, 0600));
  for (;;) pause();
}
static void count_file(int number) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", number);
  const ssize_t size = readlink(link, path, sizeof path - 1);
  if (size > 0) { path[size] = 0; count(path); }
}
#define REAL(type, name, ...) ((type (*)(__VA_ARGS__))dlsym(RTLD_NEXT, #name))
ssize_t write(int file, const void* bytes, size_t size) { count_file(file); return REAL(ssize_t, write, int, const void*, size_t)(file, bytes, size); }
ssize_t pwrite(int file, const void* bytes, size_t size, off_t at) { count_file(file); return REAL(ssize_t, pwrite, int, const void*, size_t, off_t)(file, bytes, size, at); }
ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t at) { count_file(file); return REAL(ssize_t, pwrite64, int, const void*, size_t, off64_t)(file, bytes, size, at); }
int ftruncate(int file, off_t size) { count_file(file); return REAL(int, ftruncate, int, off_t)(file, size); }
int ftruncate64(int file, off64_t size) { count_file(file); return REAL(int, ftruncate64, int, off64_t)(file, size); }
int rename(const char* from, const char* to) { count(to); return REAL(int, rename, const char*, const char*)(from, to); }
"""


def a_rank_that_is_killed_in_a_write_leaves_whole_files():
    """Wherever a step is written when the rank that writes is killed, or another."""
    shim, out = FOLDER / "stops.so", FOLDER / "long"
    (FOLDER / "stops.c").write_text(STOPS)
    subprocess.run(["cc", "-shared", "-fPIC", "-o", str(shim), str(FOLDER / "stops.c"), "-ldl"], check=True)
    last = 60
    for killed, at in ((0, random.randrange(last)), (0, random.randrange(last)), (2, random.randrange(last))):
        print("rank", killed, "at write", at)
        stopped = FOLDER / "long.stopped"
        stopped.unlink(missing_ok=True)
        process, _ = started(environment={"LD_PRELOAD": str(shim), "STOP_IN": str(out), "STOP_AT": str(at)})
        until = time.monotonic() + SECONDS
        while not stopped.exists():
            assert time.monotonic() < until and process.poll() is None, process.communicate()
            time.sleep(0.02)
        expect_end(process, killed)
        expect_whole_files(out)


run_and_remove(globals())
