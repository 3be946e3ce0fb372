#!/usr/bin/env python3
# suite
"""A Slurm job array as in the README: a controller and one node are started here, with ports, folders and a
configuration of their own and without any authentication; they end with the test.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import shutil
import socket
import subprocess
import time

from bench import COMMON, SECONDS, harness, random_points, run_checks

PROGRAMS = ("slurmctld", "slurmd", "sbatch", "sinfo")

CONFIGURATION = """\
ClusterName=graze
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/none
CredType=cred/none
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
SchedulerParameters=batch_sched_delay=0,sched_interval=1
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""

SCRIPT = """\
#!/bin/sh
#SBATCH --array=1-5
i=$SLURM_ARRAY_TASK_ID
exec {graze} classify --shard $i/5 --jobs 1 --receipt receipt.txt --resume part-$i.csv {scene}
"""


def free_ports(count):
    """Free ports."""
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Cluster:
    """A controller and a node; environment is what its clients need."""

    def __init__(self, folder):
        host = socket.gethostname().split(".")[0]
        for name in ("state", "spool"):
            (folder / name).mkdir()
        path = folder / "slurm.conf"
        path.write_text(CONFIGURATION.format(host=host, ports=free_ports(2), folder=folder, cpus=os.cpu_count()))
        self.environment = dict(os.environ, SLURM_CONF=str(path))
        self.folder, self.children = folder, []
        for program in ("slurmctld", "slurmd"):
            with open(folder / f"{program}.out", "wb") as out:
                self.children.append(subprocess.Popen([program, "-D", "-f", str(path)], stdout=out, stderr=out,
                                                      env=self.environment, cwd=folder))

    def is_up(self):
        """Wait for the node, half a minute at the most."""
        end = time.monotonic() + 30
        while time.monotonic() < end and all(child.poll() is None for child in self.children):
            seen = harness.run(["sinfo", "-h", "-o", "%T"], env=self.environment)
            if seen.stdout.strip() == "idle":
                return True
            time.sleep(0.3)
        return False

    def close(self):
        for child in reversed(self.children):
            child.terminate()
        for child in self.children:
            try:
                child.wait(20)
            except subprocess.TimeoutExpired:
                child.kill()
                child.wait()


def check_array(bench, cluster):
    """The parts of a job array merge into the table of one run, also when a task was interrupted before."""
    points = bench.file("points.csv", random_points(bench.random, 400, 3))
    scene = f"{COMMON / 'cube.off'} {COMMON / 'move3.json'} {points}"
    bench.good("check", "--receipt", bench.folder / "receipt.txt", *scene.split()[:2])
    whole = bench.good("classify", *scene.split())
    begun = bench.good("classify", *scene.split(), "--shard", "2/5")
    bench.file("part-2.csv", begun[:len(begun) // 2])
    bench.file("graze.sh", SCRIPT.format(graze=bench.graze, scene=scene).encode())
    done = harness.run(["sbatch", "--wait", "graze.sh"], SECONDS, cwd=bench.folder, env=cluster.environment,
                       stderr=subprocess.STDOUT)
    told = b"".join(path.read_bytes() for path in bench.folder.glob("slurm-*.out"))
    bench.check(done.returncode == 0, "the array is done", done.stdout, told)
    bench.check(told == b"", "its tasks say nothing", told)
    parts = sorted(bench.folder.glob("part-*.csv"))
    bench.check(len(parts) == 5 and bench.good("merge", *parts) == whole, "five tasks merge into the whole", parts)


def check_slurm(bench):
    missing = [program for program in PROGRAMS if not shutil.which(program)]
    if missing or os.geteuid() != 0:
        bench.checks.skip("slurm", f"{', '.join(missing)} not installed" if missing else "slurmd wants to be root")
        return
    cluster = Cluster(bench.folder)
    try:
        if cluster.is_up():
            check_array(bench, cluster)
        else:
            bench.checks.skip("slurm", "a node of its own does not come up here")
    finally:
        cluster.close()


if __name__ == "__main__":
    run_checks(__doc__, [check_slurm])
