"""The build backend that pip calls (PEP 517): builds the wheel and the source archive. CMake builds the extension module;
all other files are copied."""
import base64
import hashlib
import io
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
# The files and folders of the engine that the source archive contains, in addition to the Python package, so that the
# module can be built from it.
SOURCES = ["CMakeLists.txt", "LICENSE", "cmake", "include", "src", "scenes"]
PARALLEL = "CMAKE_BUILD_PARALLEL_LEVEL"


def source():
    """The folder of the engine: the parent folder in the repository, the subfolder `engine` in the source archive."""
    for folder in (HERE / "engine", HERE.parent):
        if (folder / "include" / "cairn" / "version.h").exists():
            return folder
    raise RuntimeError(f"the engine's source is neither in {HERE / 'engine'} nor in {HERE.parent}")


def project():
    with open(HERE / "pyproject.toml", "rb") as file:
        return tomllib.load(file)["project"]


def version():
    text = (source() / "include" / "cairn" / "version.h").read_text(encoding="utf-8")
    return re.search(r'version_string = "([^"]+)"', text)[1]


def stem():
    """The part that the names of all archives begin with: name and version."""
    return f"{project()['name'].replace('-', '_')}-{version()}"


def metadata():
    about = project()
    lines = ["Metadata-Version: 2.1", f"Name: {about['name']}", f"Version: {version()}", f"Summary: {about['description']}",
             f"Requires-Python: {about['requires-python']}", f"License: {about['license']['text']}",
             *(f"Classifier: {c}" for c in about["classifiers"]), *(f"Requires-Dist: {d}" for d in about["dependencies"]),
             "Description-Content-Type: text/markdown"]
    return "\n".join(lines) + "\n\n" + (HERE / about["readme"]).read_text(encoding="utf-8")


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{re.sub(r'[-.]', '_', sysconfig.get_platform())}"


def build_module(folder):
    """Builds the extension module in a folder, and returns its file. The environment variable CMAKE_ARGS can contain
    further options for CMake."""
    for tool in ("cmake", "c++"):
        if not shutil.which(tool):
            raise RuntimeError(f"{tool} is not installed; it is required to build the module")
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DCAIRN_PYTHON=ON", "-DCAIRN_APP=OFF", "-DCAIRN_TESTS=OFF", "-DCAIRN_C_API=OFF",
               f"-DPython_EXECUTABLE={sys.executable}", *shlex.split(os.environ.get("CMAKE_ARGS", ""))]
    # The variables that pip sets for its isolated build must not reach the programs that CMake runs.
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "PIP_", "VIRTUAL_ENV"))}
    environment.setdefault(PARALLEL, str(os.cpu_count() or 1))
    subprocess.run(["cmake", "-S", source(), "-B", folder, *generator, *options], check=True, env=environment)
    subprocess.run(["cmake", "--build", folder, "--target", "cairn_python"], check=True, env=environment)
    return next((pathlib.Path(folder) / "python" / "cairn").glob("_cairn*.so"))


def package_files():
    """Yields (name in the package, file) for all files of the package except the extension module."""
    for file in sorted((HERE / "cairn").rglob("*")):
        if file.suffix in (".py", ".pyi") or file.name == "py.typed":
            yield f"cairn/{file.relative_to(HERE / 'cairn').as_posix()}", file


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """With `--config-settings build-folder=FOLDER`, CMake builds in that folder, which is kept for later builds."""
    name = f"{stem()}-{tag()}.whl"
    with tempfile.TemporaryDirectory() as temporary:
        module = build_module((config_settings or {}).get("build-folder", temporary))
        contents = [(path, file.read_bytes()) for path, file in package_files()]
        contents.append((f"cairn/{module.name}", module.read_bytes()))
        about = f"{stem()}.dist-info"
        contents.append((f"{about}/METADATA", metadata().encode()))
        contents.append((f"{about}/WHEEL", f"Wheel-Version: 1.0\nGenerator: cairn_build\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode()))
        contents.append((f"{about}/LICENSE", (source() / "LICENSE").read_bytes()))
        record = ""
        with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as archive:
            for path, data in contents:
                digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
                record += f"{path},sha256={digest},{len(data)}\n"
                _add(archive, path, data)
            _add(archive, f"{about}/RECORD", f"{record}{about}/RECORD,,\n".encode())
    return name


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    about = pathlib.Path(metadata_directory) / f"{stem()}.dist-info"
    about.mkdir(parents=True)
    (about / "METADATA").write_text(metadata(), encoding="utf-8")
    return about.name


def _add(archive, path, data):
    """Adds a file with a constant date, so that the same source gives the same wheel."""
    entry = zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0))
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.external_attr = (0o755 if path.endswith(".so") else 0o644) << 16
    archive.writestr(entry, data)


def build_sdist(sdist_directory, config_settings=None):
    name = f"{stem()}.tar.gz"

    def wanted(entry):
        return None if "__pycache__" in entry.name or entry.name.endswith(".so") else entry

    with tarfile.open(os.path.join(sdist_directory, name), "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for file in ("pyproject.toml", "README.md", "cairn_build.py", "CMakeLists.txt", "cairn", "module", "examples"):
            archive.add(HERE / file, f"{stem()}/{file}", filter=wanted)
        for file in SOURCES:
            archive.add(source() / file, f"{stem()}/engine/{file}", filter=wanted)
        # CMake expects the package in the engine's folder `python`.
        for file in ("CMakeLists.txt", "cairn", "module"):
            archive.add(HERE / file, f"{stem()}/engine/python/{file}", filter=wanted)
        text = metadata().encode()
        entry = tarfile.TarInfo(f"{stem()}/PKG-INFO")
        entry.size = len(text)
        archive.addfile(entry, io.BytesIO(text))
    return name


def get_requires_for_build_wheel(config_settings=None):
    return []


def get_requires_for_build_sdist(config_settings=None):
    return []
