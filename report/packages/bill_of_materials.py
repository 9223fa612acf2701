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


def said_by_dpkg(*words):
    """Lines; of a question about many things, as it takes dpkg as long as one about one."""
    return subprocess.run(["dpkg-query", *words], capture_output=True, text=True).stdout.splitlines()


def packages_of(files):
    names = {}  # dpkg knows a file by one of two names where /lib is a link to /usr/lib
    for file in files:
        real = os.path.realpath(file)
        names[real] = names[re.sub("^/usr/", "/", real)] = file
    owner = {}
    for line in said_by_dpkg("--search", *names):
        package, path = line.split(": ", 1)
        owner[names[path]] = re.match("[^:,]+", package)[0]
    if lost := sorted(set(files) - set(owner)):
        sys.exit(f"no package has {', '.join(lost)}")
    return set(owner.values())


def installed(packages):
    """Name to (version, source, source's version)."""
    rows = (line.split("\t") for line in said_by_dpkg(
        "-W", "-f", "${db:Status-Status}\t${Package}\t${Version}\t${source:Package}\t${source:Version}\n", *packages))
    return {row[1]: row[2:] for row in rows if row[0] == "installed"}


def main():
    program, version, out = sys.argv[1:]
    rows = {row["package"]: row for row in csv.DictReader(pathlib.Path(__file__).with_name("libraries.csv").open(encoding="utf-8"))}
    loaded = subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout
    linked = packages_of(set(re.findall(r"=> (/\S+)", loaded)))
    compiled_in = {name for name, row in rows.items() if row["place"] == "headers"}
    system = dict(re.findall(r'^(\w+)="?([^"\n]*)"?$', pathlib.Path("/etc/os-release").read_text(), re.MULTILINE))
    all_installed = installed(linked | compiled_in)
    if lost := sorted((linked | compiled_in) - set(all_installed)):
        sys.exit(f"not installed: {', '.join(lost)}; the program is not of this system")
    components = []
    for name, found in sorted(all_installed.items()):
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
