"""The bill of materials of a built program, as CycloneDX 1.5: python3 bill_of_materials.py PROGRAM VERSION OUT

Components are the packages of this system whose libraries the program loads, or whose headers are compiled into it (libraries.csv), with
their versions here. Licences are those that libraries.csv states; a package that it does not name has none. The same system and program
give the same bytes: no date, no random number.
"""
import csv
import json
import os
import pathlib
import re
import subprocess
import sys


def installed(package):
    """(version, source, source's version), None if the package is not installed."""
    form = "${db:Status-Status}\t${Version}\t${source:Package}\t${source:Version}\n"
    done = subprocess.run(["dpkg-query", "-W", "-f", form, package], capture_output=True, text=True)
    fields = done.stdout.split("\n")[0].split("\t")
    return fields[1:] if done.returncode == 0 and fields[0] == "installed" else None


def package_of(file):
    real = os.path.realpath(file)
    for path in (real, re.sub("^/usr/", "/", real)):  # dpkg knows a file by one of two names where /lib is a link
        done = subprocess.run(["dpkg-query", "--search", path], capture_output=True, text=True)
        if done.returncode == 0:
            return re.match("[^:,]+", done.stdout)[0]
    sys.exit(f"{file}: no package has it")


def main():
    program, version, out = sys.argv[1:]
    rows = {row["package"]: row for row in csv.DictReader(pathlib.Path(__file__).with_name("libraries.csv").open(encoding="utf-8"))}
    loaded = subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout
    linked = {package_of(file) for file in re.findall(r"=> (/\S+)", loaded)}
    compiled_in = {name for name, row in rows.items() if row["place"] == "headers"}
    system = dict(re.findall(r'^(\w+)="?([^"\n]*)"?$', pathlib.Path("/etc/os-release").read_text(), re.MULTILINE))
    components = []
    for name in sorted(linked | compiled_in):
        found = installed(name)
        if not found:
            sys.exit(f"{name} is not installed: the program is not of this system")
        component = {
            "type": "library", "name": name, "version": found[0],
            "purl": f"pkg:deb/{system['ID']}/{name}@{found[0].replace('+', '%2B').replace(':', '%3A')}?arch=amd64&distro={system['ID']}-{system['VERSION_ID']}",
            "properties": [{"name": "luxgate:place", "value": "linked" if name in linked else "compiled in"},
                           {"name": "luxgate:source", "value": f"{found[1]} {found[2]}"}]}
        if name in rows:
            component["licenses"] = [{"license": {"name": rows[name]["licence"]}}]
        components.append(component)
    bill = {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1,
            "metadata": {"component": {"type": "application", "name": "luxgate", "version": version, "licenses": [{"license": {"id": "Apache-2.0"}}]}},
            "components": components}
    pathlib.Path(out).write_text(json.dumps(bill, indent=2) + "\n")


main()
