#!/usr/bin/env python3
# suite
"""A Slurm job array as in the README: a controller and one node are started here, with ports, folders and a
configuration of their own and without any authentication; they end with the test.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import os
import shutil
import socket
import subprocess
import tempfile
import time

from shards import COMMON, SECONDS, Bench, random_points

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
    """Ports that nobody listens at."""
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
            seen = subprocess.run(["sinfo", "-h", "-o", "%T"], env=self.environment, stdout=subprocess.PIPE,
                                  stderr=subprocess.DEVNULL, timeout=60)
            if seen.stdout.strip() == b"idle":
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
    done = subprocess.run(["sbatch", "--wait", "graze.sh"], cwd=bench.folder, env=cluster.environment,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=SECONDS)
    told = b"".join(path.read_bytes() for path in bench.folder.glob("slurm-*.out"))
    bench.check(done.returncode == 0, "the array is done", done.stdout, told)
    bench.check(told == b"", "its tasks say nothing", told)
    parts = sorted(bench.folder.glob("part-*.csv"))
    bench.check(len(parts) == 5 and bench.good("merge", *parts) == whole, "five tasks merge into the whole", parts)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--scale", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    words = parser.parse_args()
    print(f"seed {words.seed}")
    missing = [program for program in PROGRAMS if not shutil.which(program)]
    with tempfile.TemporaryDirectory(prefix="graze-slurm-") as folder:
        bench = Bench(os.path.abspath(words.graze), folder, words.scale, words.seed)
        if missing or os.geteuid() != 0:
            bench.skip("slurm", f"{', '.join(missing)} not installed" if missing else "slurmd wants to be root")
        else:
            cluster = Cluster(bench.folder)
            try:
                if cluster.is_up():
                    check_array(bench, cluster)
                else:
                    bench.skip("slurm", "a node of its own does not come up here")
            finally:
                cluster.close()
        print(f"{bench.passed} passed, {bench.failed} failed, {bench.skipped} skipped")
        return bench.failed > 0


if __name__ == "__main__":
    raise SystemExit(main())
