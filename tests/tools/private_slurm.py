"""Slurm with one node for a test: its daemons, key and socket are private, and end with it."""
import ctypes
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time

NEEDED = ["slurmctld", "slurmd", "munged", "sbatch", "scontrol", "squeue"]
CONFIG = """ClusterName=luxgate
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,batch_sched_delay=1,sched_min_interval=100000
SlurmdParameters=config_overrides
ReturnToService=2
SlurmdTimeout=20
MinJobAge=300
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def why_not():
    """"" or why it cannot be started here."""
    missing = [name for name in NEEDED if shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin") is None]
    if missing:
        return ", ".join(missing) + " not installed"
    return "" if os.geteuid() == 0 else "not root"


def end_with_the_test():
    """In a daemon, before it starts: however the test is killed, it ends, too."""
    set_signal_of_parents_death = 1
    ctypes.CDLL(None).prctl(set_signal_of_parents_death, signal.SIGTERM)


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class PrivateSlurm:
    """problem: "" once it runs, else why not. environment: of commands that use it."""

    def __init__(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="slurm-"))  # short: a socket's path is
        self.folder.chmod(0o755)
        self.host = socket.gethostname().split(".")[0]
        self.daemons = []
        path = os.environ["PATH"] + ":/usr/sbin"
        self.environment = {**os.environ, "PATH": path, "SLURM_CONF": str(self.folder / "slurm.conf")}
        self.problem = why_not()

    def __enter__(self):
        if not self.problem:
            try:
                self.start()
            except BaseException:
                self.__exit__()
                raise
        return self

    def daemon(self, *command):
        with open(self.folder / f"{command[0]}.out", "wb") as out:
            self.daemons.append(subprocess.Popen(command, env=self.environment, stdin=subprocess.DEVNULL, stdout=out,
                                                 stderr=subprocess.STDOUT, start_new_session=True, preexec_fn=end_with_the_test))

    def start(self):
        munge = self.folder / "munge"
        munge.mkdir(mode=0o755)
        for name in ["state", "spool"]:
            (self.folder / name).mkdir()
        key = munge / "key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        cpus = max(16, os.cpu_count())  # for small shards: nothing has to wait
        (self.folder / "slurm.conf").write_text(CONFIG.format(host=self.host, ports=free_ports(2), folder=self.folder, cpus=cpus))
        self.daemon("munged", "--foreground", "--force", f"--socket={munge}/socket", f"--key-file={key}", f"--pid-file={munge}/pid",
                    f"--seed-file={munge}/seed", f"--log-file={munge}/log")
        if not self.wait(lambda: (munge / "socket").exists(), 10):
            self.problem = "munged does not start"
            return
        self.daemon("slurmctld", "-D", "-c")
        self.daemon("slurmd", "-D")
        if not self.wait(lambda: "idle" in self.run("sinfo", "--noheader", "-o", "%T").stdout, 25):
            self.problem = "Slurm does not come up: " + (self.folder / "slurmctld.out").read_text()[-500:]

    def wait(self, is_so, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if is_so():
                return True
            if any(daemon.poll() is not None for daemon in self.daemons):
                return False
            time.sleep(0.2)
        return False

    def run(self, *command):
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False)

    def __exit__(self, *_):
        if len(self.daemons) == 3:
            self.run("scancel", "--state=PENDING", "-u", "root")
            self.run("scancel", "-u", "root")
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in reversed(self.daemons):
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        shutil.rmtree(self.folder, ignore_errors=True)
