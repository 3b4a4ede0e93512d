"""Makes the wheel of the Python package: its modules, the program, and the licences, as one file whose
bytes depend on these alone (PEP 427).

usage: python3 tools/wheel.py PROGRAM LICENCES FOLDER
"""

import base64
import hashlib
import os
import re
import sys
import zipfile

TAG = "py3-none-manylinux2014_x86_64.manylinux_2_17_x86_64.musllinux_1_1_x86_64"
SUMMARY = "Recognise objects by touch, and test decoders of pseudorandom arrays"


def main(program, licences, folder):
    with open("pra-tactile.cabal") as cabal:
        version = re.search(r"^version: *(\S+)", cabal.read(), re.M)[1]
    info = f"pra_tactile-{version}.dist-info"
    files = {f"pra_tactile/{name}": path for name, path in sources()}
    files["pra_tactile/bin/pra-tactile"] = program
    files[f"{info}/licenses/LICENSE"] = "LICENSE"
    files[f"{info}/licenses/LICENCES.txt"] = licences
    contents = {}
    for name, path in files.items():
        with open(path, "rb") as file:
            contents[name] = file.read()
    tags = [f"Tag: py3-none-{platform}\n" for platform in TAG.split("-")[-1].split(".")]
    contents[f"{info}/METADATA"] = metadata(version)
    contents[f"{info}/WHEEL"] = ("Wheel-Version: 1.0\nGenerator: pra-tactile\nRoot-Is-Purelib: false\n" + "".join(tags)).encode()
    contents[f"{info}/entry_points.txt"] = b"[console_scripts]\npra-tactile = pra_tactile.__main__:main\n"
    record = f"{info}/RECORD"
    rows = [f"{name},sha256={digest(data)},{len(data)}\n" for name, data in sorted(contents.items())]
    contents[record] = ("".join(rows) + f"{record},,\n").encode()
    os.makedirs(folder, exist_ok=True)
    wheel = os.path.join(folder, f"pra_tactile-{version}-{TAG}.whl")
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, data in sorted(contents.items()):
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.create_system = 3
            entry.external_attr = (0o100755 if name.endswith("/bin/pra-tactile") else 0o100644) << 16
            archive.writestr(entry, data)
    print(wheel)


def sources():
    folder = os.path.join("python", "pra_tactile")
    for name in sorted(os.listdir(folder)):
        if name.endswith((".py", ".typed")):
            yield name, os.path.join(folder, name)


def digest(data):
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()


def metadata(version):
    with open(os.path.join("python", "README.md"), encoding="utf-8") as readme:
        return (
            f"Metadata-Version: 2.1\nName: pra-tactile\nVersion: {version}\nSummary: {SUMMARY}\n"
            "License: BSD-3-Clause\nRequires-Python: >=3.8\nDescription-Content-Type: text/markdown\n"
            "Classifier: Operating System :: POSIX :: Linux\nClassifier: Typing :: Typed\n\n" + readme.read()
        ).encode()


main(*sys.argv[1:])
