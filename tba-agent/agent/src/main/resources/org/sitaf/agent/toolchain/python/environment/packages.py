"""What the agent asks of packages, each in a process of the sandbox. Runs no code of a package.

    packages.py source NAME SPECIFIER   fetches the newest source archive that fits, into the working folder
    packages.py wheel FILE              reads name, version and requirements of a wheel
    packages.py build FILE              reads what a source archive needs to be built
    packages.py unpack (FILE FOLDER)... installs each wheel alone into its folder, as into an environment

Answers are lines `word TAB value` on the output; what went wrong is one line on the error stream.
"""

import email.parser
import hashlib
import os
import platform
import sys
import tarfile
import zipfile

MAX_ARCHIVE_BYTES = 256 << 20
MAX_METADATA_BYTES = 1 << 20
MAX_UNPACKED_FILES = 300_000
MAX_UNPACKED_BYTES = 16 << 30
SUFFIXES = (".tar.gz", ".zip", ".tgz", ".tar.bz2", ".tar.xz")


def say(word, value):
    print(word, " ".join(str(value).split()), sep="\t")


def source(name, specifier):
    # pip's own finder keeps to the configuration of pip, as the wheels do; it only reads the pages of the index.
    from pip._internal.commands.download import DownloadCommand
    from pip._vendor.packaging.specifiers import SpecifierSet

    command = DownloadCommand("download", "")
    options, _ = command.parse_args(["--no-binary", ":all:", "--no-input", "--quiet"])
    with command.main_context():
        session = command.get_default_session(options)
        finder = command._build_package_finder(options, session)
        best = finder.find_best_candidate(name, SpecifierSet(specifier)).best_candidate
        if best is None:
            sys.exit(f"the index has no source archive of {name} {specifier}".strip())
        link = best.link
        if not link.filename.endswith(SUFFIXES) or "/" in link.filename:
            sys.exit(f"{link.filename} is not a source archive")
        digest = hashlib.new(link.hash_name) if link.hash_name else None
        size = 0
        with session.get(link.url_without_fragment, stream=True, headers={"Accept-Encoding": "identity"}) as response:
            response.raise_for_status()
            with open(link.filename, "wb") as file:
                for block in response.iter_content(1 << 16):
                    size += len(block)
                    if size > MAX_ARCHIVE_BYTES:
                        sys.exit(f"{link.filename} is larger than {MAX_ARCHIVE_BYTES >> 20} MiB")
                    if digest:
                        digest.update(block)
                    file.write(block)
        if digest and digest.hexdigest() != link.hash:
            sys.exit(f"{link.filename} does not have the digest that the index says")
    say("file", link.filename)
    say("version", best.version)


def metadata(path):
    with zipfile.ZipFile(path) as archive:
        found = [i for i in archive.infolist() if i.filename.endswith(".dist-info/METADATA") and i.filename.count("/") == 1]
        if len(found) != 1 or found[0].file_size > MAX_METADATA_BYTES:
            sys.exit("it is not a wheel: it has no METADATA, or several")
        return email.parser.Parser().parsestr(archive.read(found[0]).decode("utf-8", "replace"), headersonly=True)


def wheel(path):
    read = metadata(path)
    say("name", read["Name"])
    say("version", read["Version"])
    for line in read.get_all("Requires-Dist") or []:
        say("requires", line)


def build(path):
    import tomllib

    try:
        project = tomllib.loads(pyproject(path))
    except tomllib.TOMLDecodeError as e:
        sys.exit(f"its pyproject.toml cannot be read: {e}")
    wanted = project.get("build-system", {}).get("requires", [])
    for line in wanted if isinstance(wanted, list) else []:
        say("requires", line)


def pyproject(path):
    """The text of `NAME-VERSION/pyproject.toml`; empty where there is none."""
    if path.endswith(".zip"):
        with zipfile.ZipFile(path) as archive:
            for info in archive.infolist():
                if info.filename.count("/") == 1 and info.filename.endswith("/pyproject.toml") and info.file_size <= MAX_METADATA_BYTES:
                    return archive.read(info).decode("utf-8", "replace")
        return ""
    with tarfile.open(path) as archive:
        for info in archive:
            if info.isreg() and info.name.count("/") == 1 and info.name.endswith("/pyproject.toml") and info.size <= MAX_METADATA_BYTES:
                return archive.extractfile(info).read().decode("utf-8", "replace")
    return ""


def unpack(*arguments):
    from pip._internal.exceptions import PipError

    for path, folder in zip(arguments[::2], arguments[1::2], strict=True):
        try:
            install(path, folder)
        except PipError as e:
            sys.exit(f"{os.path.basename(path)}: {e}")


def install(path, folder):
    """pip's own installer, without a search for requirements: the set of wheels is complete."""
    from pip._internal.models.scheme import Scheme
    from pip._internal.models.wheel import Wheel
    from pip._internal.operations.install.wheel import install_wheel
    from pip._internal.utils.compatibility_tags import get_supported

    file = os.path.basename(path)
    wheel = Wheel(file)
    if not wheel.supported(get_supported()):
        sys.exit(f"{file} is not a supported wheel on this platform")
    with zipfile.ZipFile(path) as archive:
        sizes = [info.file_size for info in archive.infolist()]
    if len(sizes) > MAX_UNPACKED_FILES or sum(sizes) > MAX_UNPACKED_BYTES:
        sys.exit(f"{file} contains more than {MAX_UNPACKED_FILES} files or {MAX_UNPACKED_BYTES >> 30} GiB")
    required = metadata(path)["Requires-Python"]
    if required and not runs_here(required):
        sys.exit(f"{file} requires a different Python: {platform.python_version()} not in '{required}'")
    version = sys.version_info
    packages = os.path.join(folder, "lib", f"python{version.major}.{version.minor}", "site-packages")
    headers = os.path.join(folder, "include", "site", f"python{version.major}.{version.minor}", wheel.name)
    scheme = Scheme(platlib=packages, purelib=packages, headers=headers, scripts=os.path.join(folder, "bin"), data=folder)
    install_wheel(wheel.name, path, scheme, file, warn_script_location=False)


def runs_here(required):
    from pip._vendor.packaging.specifiers import InvalidSpecifier, SpecifierSet

    try:
        return SpecifierSet(required).contains(platform.python_version(), prereleases=True)
    except InvalidSpecifier:
        # pip ignores it too.
        return True


if __name__ == "__main__":
    sys.stdout.reconfigure(encoding="utf-8", errors="replace")
    try:
        {"source": source, "wheel": wheel, "build": build, "unpack": unpack}[sys.argv[1]](*sys.argv[2:])
    except (OSError, ValueError, zipfile.BadZipFile, tarfile.TarError, RuntimeError, NotImplementedError) as e:
        sys.exit(f"{type(e).__name__}: {e}")
