"""A Slurm of one's own on this machine: some nodes on loopback, all files in one folder, nothing of the system's
configuration read or touched. Needs munged, slurmctld and slurmd (Debian's munge, slurmctld, slurmd, slurm-client)."""
import getpass, os, shutil, signal, socket, subprocess, time
from pathlib import Path

DAEMONS = ("munged", "slurmctld", "slurmd")


def missing():
    """Programs that a cluster needs and this machine has not."""
    path = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"
    return [name for name in (*DAEMONS, "sbatch", "scontrol") if shutil.which(name, path=path) is None]


def _free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class PrivateCluster:
    """with PrivateCluster(folder, nodes=2, cpus=1) as cluster: cluster.run("sbatch", ...)"""

    def __init__(self, folder, nodes=2, cpus=1):
        self.folder, self.cpus = Path(folder).resolve(), cpus
        self.nodes = {f"n{number}": None for number in range(1, nodes + 1)}
        self.environment = os.environ | {"SLURM_CONF": str(self.folder / "slurm.conf"),
                                         "PATH": os.environ.get("PATH", "") + ":/usr/sbin:/sbin"}
        self.daemons = []

    def _configuration(self):
        host, user = socket.gethostname().split(".")[0], getpass.getuser()
        controller, *ports = _free_ports(1 + len(self.nodes))
        nodes = "\n".join(f"NodeName={name} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs={self.cpus}"
                          for name, port in zip(self.nodes, ports))
        return f"""ClusterName=private
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={self.folder}/munge/socket,cred_expire=5
CredType=cred/munge
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
SlurmdParameters=config_overrides
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
StateSaveLocation={self.folder}/state
SlurmdSpoolDir={self.folder}/spool.%n
SlurmctldPidFile={self.folder}/slurmctld.pid
SlurmdPidFile={self.folder}/%n.pid
SlurmctldLogFile={self.folder}/slurmctld.log
SlurmdLogFile={self.folder}/%n.log
ReturnToService=2
SlurmdTimeout=2
KillWait=5
SchedulerParameters=sched_interval=1,bf_interval=1,sched_min_interval=0,batch_sched_delay=0
{nodes}
PartitionName=main Nodes={",".join(self.nodes)} Default=YES MaxTime=INFINITE State=UP
"""

    def _start(self, *command):
        daemon = subprocess.Popen(list(map(str, command)), env=self.environment, stdin=subprocess.DEVNULL,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        self.daemons.append(daemon)
        return daemon

    def _until(self, happened, what, seconds=30):
        end = time.monotonic() + seconds
        while not happened():
            if time.monotonic() > end:
                logs = "\n".join(path.read_text(errors="replace")[-2000:] for path in self.folder.glob("*.log"))
                raise TimeoutError(f"{what} within {seconds} s:\n{logs}")
            time.sleep(0.05)

    def __enter__(self):
        for name in ("munge", "state", *(f"spool.{node}" for node in self.nodes)):
            (self.folder / name).mkdir(parents=True)
        munge = self.folder / "munge"
        munge.chmod(0o755)
        (munge / "key").write_bytes(os.urandom(128))
        (munge / "key").chmod(0o600)
        (self.folder / "slurm.conf").write_text(self._configuration())
        try:
            self._start("munged", "--foreground", "--force", "--key-file", munge / "key", "--socket", munge / "socket", "--pid-file", munge / "pid",
                        "--log-file", munge / "log", "--seed-file", munge / "seed", "--num-threads", 2)
            self._until((munge / "socket").exists, "munged does not answer")
            self._start("slurmctld", "-D")
            for node in self.nodes:
                self.nodes[node] = self._start("slurmd", "-D", "-N", node)
            self._until(lambda: self.states().count("idle") == len(self.nodes), "the nodes are not idle")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        for process in self._processes_of(""):
            os.kill(process, signal.SIGKILL)

    def run(self, *command, check=True, **options):
        done = subprocess.run(list(map(str, command)), env=self.environment, capture_output=True, text=True, **options)
        assert done.returncode == 0 or not check, f"{' '.join(map(str, command))}: {done.stderr}"
        return done

    def states(self):
        done = self.run("sinfo", "-N", "-h", "-o", "%t", check=False)
        return done.stdout.split()

    def queue(self, job):
        """States of the tasks of a job that have not ended, PENDING or RUNNING and others."""
        return self.run("squeue", "-r", "-h", "-j", job, "-o", "%T", check=False).stdout.split()

    def _processes_of(self, node):
        """What a node runs, by the environment that Slurm gives it; of every node where none is named."""
        wanted = [f"SLURM_CONF={self.folder}/slurm.conf".encode()]
        if node:
            wanted.append(f"SLURMD_NODENAME={node}".encode())
        found = []
        for process in Path("/proc").glob("[0-9]*"):
            try:
                environment = (process / "environ").read_bytes().split(b"\0")
            except OSError:
                continue
            if int(process.name) != os.getpid() and all(entry in environment for entry in wanted):
                found.append(int(process.name))
        return found

    def kill_node(self, node):
        """As a power cut: its daemon, those that look after its jobs, and what they run, before one can tell of another."""
        jobs = self._processes_of(node)
        keepers = {parent for parent in map(_parent_of, jobs) if _name_of(parent) == "slurmstepd"}
        for process in (self.nodes[node].pid, *keepers, *jobs):
            try:
                os.kill(process, signal.SIGKILL)
            except ProcessLookupError:
                pass


def _status_of(process, field):
    try:
        lines = Path(f"/proc/{process}/status").read_text().splitlines()
    except OSError:
        return ""
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith(field + ":")), "")


def _parent_of(process):
    return int(_status_of(process, "PPid") or 0)


def _name_of(process):
    return _status_of(process, "Name")
