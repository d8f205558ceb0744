"""scripts/sweep_slurm on a real Slurm of one node, started here on loopback with keys, ports and files of its own."""

import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests/cli"))
from support import HEALTHY, PROGRAM  # noqa: E402

NEEDED = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "sinfo", "scontrol")
INSTALL = "apt-get install --no-install-recommends slurmctld slurmd slurm-client munge"
LIMIT_S = 90
CONFIG = """ClusterName=trunk
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={control_port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,bf_interval=1
ReturnToService=2
SlurmdParameters=config_overrides
NodeName={host} NodeAddr=127.0.0.1 CPUs=4 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
"""


def program(name):
    return shutil.which(name, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin")


def free_ports(count):
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [s.getsockname()[1] for s in sockets]
    for s in sockets:
        s.close()
    return ports


class Slurm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        missing = [name for name in NEEDED if not program(name)]
        if missing:
            raise unittest.SkipTest(f"no {', '.join(missing)} here: {INSTALL}")
        cls.folder = Path(tempfile.mkdtemp(prefix="trunk_slurm_"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.folder.chmod(0o755)  # munged wants it
        cls.environment = {**os.environ, "SLURM_CONF": str(cls.folder / "slurm.conf"), "TRUNK": PROGRAM}
        cls.daemons = []
        cls.addClassCleanup(cls.end_daemons)
        cls.configure()
        cls.start_daemons()

    @classmethod
    def configure(cls):
        for name in ("state", "spool"):
            (cls.folder / name).mkdir()
        key = cls.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        control_port, node_port = free_ports(2)
        host = socket.gethostname().split(".")[0]
        user = subprocess.run(["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
        (cls.folder / "slurm.conf").write_text(CONFIG.format(
            folder=cls.folder, host=host, user=user, control_port=control_port, node_port=node_port))
        (cls.folder / "cgroup.conf").write_text("CgroupAutomount=no\n")

    @classmethod
    def start_daemons(cls):
        at = {name: str(cls.folder / f"munge.{name}") for name in ("key", "socket", "pid", "log", "seed")}
        cls.daemon("munged", "--foreground", f"--key-file={at['key']}", f"--socket={at['socket']}",
                   f"--pid-file={at['pid']}", f"--log-file={at['log']}", f"--seed-file={at['seed']}")
        cls.wait_for("munged", lambda: Path(at["socket"]).exists())
        cls.daemon("slurmctld", "-D", "-c")
        cls.daemon("slurmd", "-D", "-c")
        cls.wait_for("slurmd", lambda: "idle" in cls.slurm("sinfo", "--noheader", "-o", "%T").stdout)

    @classmethod
    def daemon(cls, name, *options):
        log = (cls.folder / f"{name}.out").open("w")
        cls.daemons.append(subprocess.Popen([program(name), *options], env=cls.environment, stdin=subprocess.DEVNULL,
                                            stdout=log, stderr=subprocess.STDOUT, start_new_session=True))
        log.close()

    @classmethod
    def end_daemons(cls):
        for process in reversed(cls.daemons):
            process.terminate()
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

    @classmethod
    def wait_for(cls, name, ready):
        """Where daemons do not come up the tests are skipped: that is the machine's fault, not ours."""
        deadline = time.monotonic() + 30
        while not ready():
            if time.monotonic() > deadline or any(d.poll() is not None for d in cls.daemons):
                last = [(p.name, p.read_text().strip().splitlines()[-3:]) for p in sorted(cls.folder.glob("*.out"))]
                raise unittest.SkipTest(f"{name} does not start on this machine: {last}")
            time.sleep(0.2)

    @classmethod
    def slurm(cls, name, *arguments):
        return subprocess.run([program(name), *map(str, arguments)], env=cls.environment, cwd=cls.folder, text=True,
                              capture_output=True, timeout=LIMIT_S)

    def submit(self, *arguments):
        outcome = self.slurm("sbatch", "--parsable", "-o", self.folder / "task-%a.log", "-e", self.folder / "task-%a.log",
                             *arguments)
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        return outcome.stdout.strip()

    def finish(self, job):
        deadline = time.monotonic() + LIMIT_S
        while self.slurm("squeue", "--noheader", "-j", job).stdout.strip():
            self.assertLess(time.monotonic(), deadline, self.logs())
            time.sleep(0.3)

    def logs(self):
        return "\n".join(f"{p.name}: {p.read_text()}" for p in sorted(self.folder.glob("task-*.log")))

    def trunk(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, text=True, capture_output=True)

    def design(self, name, runs, duration_s):
        path = self.folder / f"{name}.toml"
        path.write_text(f'store = "summary"\nscenarios = ["{HEALTHY}"]\n[grid]\n"time.dt_ms" = [3]\n'
                        f'"time.duration_s" = [{duration_s}]\n[sample]\nmethod = "sobol"\npoints = {runs}\n'
                        '"parameters.k_muscle_N_per_m" = { from = 10, to = 60 }\n')
        return path

    def test_an_array_makes_the_table_of_one_process(self):
        design = self.design("array", 60, 0.3)
        self.finish(self.submit("--array=1-4", ROOT / "scripts/sweep_slurm", design, self.folder / "array"))
        self.assertEqual(self.trunk("sweep", design, "-o", "alone").returncode, 0)
        table = self.folder / "array/table.csv"
        self.assertTrue(table.is_file(), self.logs())
        self.assertEqual(table.read_bytes(), (self.folder / "alone/table.csv").read_bytes())
        self.assertEqual(sorted(p.name for p in (self.folder / "array/journal").iterdir()),
                         [f"{k}-of-4" for k in (1, 2, 3, 4)])

    def test_a_killed_array_goes_on(self):
        design, folder = self.design("killed", 400, 2.0), self.folder / "killed"
        job = self.submit("--array=1-2", ROOT / "scripts/sweep_slurm", design, folder)
        done = lambda: int(re.search(r'"done": (\d+)', self.trunk("status", folder, "--json").stdout or '"done": 0')[1])
        deadline = time.monotonic() + LIMIT_S
        while done() < 20:
            self.assertLess(time.monotonic(), deadline, self.logs())
        self.slurm("scancel", "--signal=KILL", "--full", job)
        self.slurm("scancel", job)
        self.finish(job)
        kept = done()
        self.assertTrue(20 <= kept < 400, kept)
        self.assertFalse((folder / "table.csv").exists())
        self.finish(self.submit("--array=1-2", ROOT / "scripts/sweep_slurm", design, folder))
        found = [int(n) for n in re.findall(r"(\d+) found done", self.logs())]
        self.assertGreaterEqual(sum(found[-2:]), kept, self.logs())
        self.assertEqual(self.trunk("sweep", design, "-o", "whole").returncode, 0)
        self.assertEqual((folder / "table.csv").read_bytes(), (self.folder / "whole/table.csv").read_bytes())


if __name__ == "__main__":
    unittest.main()
