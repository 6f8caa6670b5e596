"""Starts programs on several ranks, as users start them; for tests that are called with MPIRUN|none FOLDER CASE."""
import os
import subprocess
import sys

MPIRUN, FOLDER, CASE = sys.argv[1:4]
# More ranks than processors, also as root. Ranks that wait give their processor to others, and run on any, since tests share them. A start
# does not look for networks, which takes a third of its time.
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_mpi_yield_when_idle="1",
                   OMPI_MCA_hwloc_base_binding_policy="none", OMPI_MCA_pml="ob1", OMPI_MCA_btl="vader,self",
                   OMPI_MCA_btl_vader_single_copy_mechanism="none", OMP_NUM_THREADS="1",
                   ASAN_OPTIONS="detect_leaks=0",  # MPI has some
                   PHYSGEN_STARTED_BY=str(os.getpid()))
SECONDS = 240  # what takes longer hangs


def run(*command, environment=None):
    """Status, output and errors of a command."""
    done = subprocess.run(command, env={**ENVIRONMENT, **(environment or {})}, capture_output=True, text=True, timeout=SECONDS, check=False)
    return done.returncode, done.stdout, done.stderr


def program(name):
    return os.path.join(FOLDER, "distributed_" + name)


def ranks(count, name, *arguments, environment=None):
    return run(MPIRUN, "--oversubscribe", "-n", str(count), program(name), *arguments, environment=environment)


def run_case(cases):
    """The status of the test that was asked for."""
    if MPIRUN == "none":
        print("skipped: MPI was not found, so there is one rank; install libopenmpi-dev and openmpi-bin")
        return 77
    cases[CASE]()
    return 0
