# SPDX-License-Identifier: LGPL-2.1-or-later
"""HexCon-x.y.z.zip from this folder's sources and the cores that release.sh has built: pack.py FOLDER.

Each core is looked at before: what it asks of its system must be there in all that the notes promise. RELEASE.md in the
zip says what was built, how it was tested and what was not; SHA256SUMS has every file.
"""
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LEFT_OUT = ("tests/", ".ci/", "scripts/release", "scripts/test_", "scripts/grid_beside/", "scripts/second_order/")
VERSION = re.compile(r'#define HEXCON_VERSION "(.*)"')
NEWEST_GLIBC = (2, 31)      # that of release/old_debian.sh
WINDOWS_LIBRARIES = {"kernel32.dll", "msvcrt.dll", "python3.dll"}
OBJDUMPS = {"linux-x86_64": "objdump", "linux-aarch64": "aarch64-linux-gnu-objdump",
            "windows-x86_64": "x86_64-w64-mingw32-objdump"}


def main(folder):
    version = VERSION.search((ROOT / "hexcon_native/include/hexcon.h").read_text()).group(1)
    cores = {system: core_of(folder, system) for system in OBJDUMPS}
    notes = release_notes(version, folder, cores)
    files = {name: (ROOT / name).read_bytes() for name in sources()}
    files |= {f"hexcon_native/built/{system}/{path.name}": path.read_bytes() for system, path in cores.items()}
    files["RELEASE.md"] = notes.encode()
    sums = "".join(f"{sum_of(what)}  {name}\n" for name, what in sorted(files.items()))
    files["SHA256SUMS"] = sums.encode()
    target = folder / f"HexCon-{version}.zip"
    write_zip(target, files)
    sum_of_all = sum_of(target.read_bytes())
    (folder / f"{target.name}.sha256").write_text(f"{sum_of_all}  {target.name}\n")
    print(f"release: {target}: {len(files)} files, {target.stat().st_size / 1e6:.1f} MB, sha256 {sum_of_all}")


def sum_of(content):
    return hashlib.sha256(content).hexdigest()


def sources():
    """Names of the files of git that a user needs; with the core's sources, so that it can be built."""
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=ROOT, check=True,
                            capture_output=True, text=True).stdout.splitlines()
    return sorted(name for name in listed if (ROOT / name).is_file() and not name.startswith(LEFT_OUT))


def core_of(folder, system):
    """Path of the core for a system; SystemExit where it asks for more than what is promised."""
    (path,) = (folder / "built" / system).glob("_core.*")
    if system.startswith("windows"):
        others = {name.lower() for name in re.findall(r"DLL Name: (\S+)", dump(system, "-p", path))} - WINDOWS_LIBRARIES
        if others:
            raise SystemExit(f"release: {path} needs {', '.join(sorted(others))}, which Windows has not")
    elif glibc_of(system, path) > NEWEST_GLIBC:
        raise SystemExit(f"release: {path} needs a newer glibc than {NEWEST_GLIBC}")
    return path


def glibc_of(system, path):
    """The newest version of glibc of which the core asks a symbol."""
    versions = re.findall(r"GLIBC_([0-9.]+)", dump(system, "-T", path))
    return max(tuple(map(int, version.split("."))) for version in versions)


def dump(system, what, path):
    return subprocess.run([OBJDUMPS[system], what, path], check=True, capture_output=True, text=True).stdout


def needs(system, path):
    if system.startswith("windows"):
        return "64-bit Windows; Python 3.11 or newer (python3.dll)"
    return f"glibc {'.'.join(map(str, glibc_of(system, path)))} or newer; Python 3.11 or newer"


def release_notes(version, folder, cores):
    rows = "".join(f"| {system} | {needs(system, path)} | {path.stat().st_size / 1e6:.1f} MB | "
                   f"{(folder / system / 'tested').read_text().strip()} | `{sum_of(path.read_bytes())}` |\n"
                   for system, path in cores.items())
    text = (ROOT / "scripts/release/notes.md").read_text(encoding="utf-8")
    return text.replace("VERSION", version).replace("CORES", rows.rstrip())


def write_zip(target, files):
    """Alike from the same files: sorted, with one date."""
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(f"HexCon/{name}", (2020, 1, 1, 0, 0, 0))
            source = ROOT / name
            entry.external_attr = (0o755 if source.is_file() and os.access(source, os.X_OK) else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, files[name])


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
