"""A Slurm whose nodes are all this machine, in a folder of its own, without munge, cgroups and systemd."""
import ctypes
import os
import pathlib
import signal
import socket
import subprocess
import time

CONFIGURATION = """
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmUser=root
SlurmdUser=root
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
SchedulerParameters=sched_min_interval=0,bf_interval=1
JobRequeue=1
ReturnToService=2
SlurmdTimeout=5
KillWait=2
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/%n.log
{nodes}
PartitionName=main Nodes=ALL Default=YES State=UP
"""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def wait_until(condition, what, seconds=300):
    """The ceiling is for a machine that is stuck: no test depends on it otherwise."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.1)
    raise TimeoutError(f"not within {seconds} s: {what}")


def processes():
    """Each process of this machine, with its words and its environment."""
    for folder in pathlib.Path("/proc").iterdir():
        if not folder.name.isdigit() or int(folder.name) == os.getpid():
            continue
        try:
            words = (folder / "cmdline").read_bytes().split(b"\0")
            environment = (folder / "environ").read_bytes().split(b"\0")
        except OSError:  # ended meanwhile
            continue
        if words != [b""]:  # dead, not yet waited for
            yield int(folder.name), words, environment


def stop(pid):
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


def end_with_parent():
    """In a child: should this program be killed, nothing that it started may stay."""
    pr_set_pdeathsig = 1
    ctypes.CDLL(None).prctl(pr_set_pdeathsig, signal.SIGKILL)


def opened_files(pid):
    try:
        return [os.readlink(file) for file in pathlib.Path(f"/proc/{pid}/fd").iterdir()]
    except OSError:
        return []


class Slurm:
    """`with Slurm(FOLDER) as slurm`: nodes n0 and n1, of one processor each."""

    nodes = ("n0", "n1")

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.configuration = self.folder / "slurm.conf"
        self.environment = {**os.environ, "SLURM_CONF": str(self.configuration)}
        self.daemons = {}

    def __enter__(self):
        (self.folder / "state").mkdir(parents=True)
        host = socket.gethostname().split(".")[0]
        ports = free_ports(1 + len(self.nodes))
        nodes = [f"NodeName={node} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs=1 RealMemory=1000"
                 for node, port in zip(self.nodes, ports[1:])]
        self.configuration.write_text(
            CONFIGURATION.format(host=host, port=ports[0], folder=self.folder, nodes="\n".join(nodes)))
        try:
            self.start("slurmctld", ["slurmctld", "-D"])
            for node in self.nodes:
                self.start_node(node)
            wait_until(self.all_are_idle, "all nodes are idle")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for daemon in self.daemons.values():
            daemon.kill()
            daemon.wait()
        for pid in self.own_processes():
            stop(pid)

    def start(self, name, words):
        with open(self.folder / f"{name}.out", "a") as out:
            self.daemons[name] = subprocess.Popen(
                words, env=self.environment, stdin=subprocess.DEVNULL, stdout=out, stderr=out,
                cwd=self.folder, preexec_fn=end_with_parent)

    def start_node(self, node):
        self.start(node, ["slurmd", "-D", "-N", node])

    def own_processes(self):
        """The daemons, their steps and jobs: what has this configuration in its environment."""
        mark = f"SLURM_CONF={self.configuration}".encode()
        return [pid for pid, _, environment in processes() if mark in environment]

    def kill_node(self, node):
        """As a power cut: its daemon, and all that runs there."""
        log = str(self.folder / f"{node}.log")
        name = f"SLURMD_NODENAME={node}".encode()
        own = set(self.own_processes())
        there = [pid for pid, _, environment in processes()
                 if pid in own and (name in environment or log in opened_files(pid))]
        for pid in there:
            stop(pid)
        self.daemons.pop(node).wait()

    def signal_task(self, node, number):
        """Signals the script of the task that runs on the node, and it alone; returns the task."""
        own = set(self.own_processes())
        for pid, words, environment in processes():
            variables = dict(line.split(b"=", 1) for line in environment if b"=" in line)
            is_script = any(word.endswith(b"/slurm_script") for word in words)
            if pid in own and is_script and variables.get(b"SLURMD_NODENAME") == node.encode():
                os.kill(pid, number)
                return variables[b"SLURM_ARRAY_TASK_ID"].decode()
        raise LookupError(f"no task runs on {node}")

    def ask(self, *words):
        return subprocess.run(words, env=self.environment, check=True, capture_output=True, text=True).stdout

    def node_states(self):
        shown = subprocess.run(["sinfo", "-h", "-N", "-p", "main", "-o", "%t"], env=self.environment,
                               check=False, capture_output=True, text=True)
        return shown.stdout.split()

    def all_are_idle(self):
        """Raises where a daemon has ended: it says why in what it printed and logged."""
        for name, daemon in self.daemons.items():
            if daemon.poll() is not None:
                said = "\n".join(file.read_text(errors="replace") for file in
                                 (self.folder / f"{name}.out", self.folder / f"{name}.log") if file.exists())
                raise RuntimeError(f"{name} ended with {daemon.returncode}: {said}")
        return self.node_states() == ["idle"] * len(self.nodes)

    def start_waiting_tasks(self):
        """Slurm keeps what it starts again waiting for two minutes, which a test need not."""
        for line in self.ask("squeue", "-h", "-r", "-t", "PENDING", "-o", "%i %r").splitlines():
            task, reason = line.split(maxsplit=1)
            if reason == "BeginTime":
                self.ask("scontrol", "update", f"JobId={task}", "StartTime=now")

    def tasks(self):
        """[task, state, node, restarts] of all jobs that wait or run."""
        printed = self.ask("squeue", "-h", "-r", "-O", "ArrayTaskID:20 ,State:20 ,NodeList:20 ,RestartCnt:10 ")
        rows = [line.split() for line in printed.splitlines()]
        return [[row[0], row[1], row[2] if len(row) == 4 else "", int(row[-1])] for row in rows]
