"""Checks a project: what is not met, the darkest place of each plane, and what a parameter does.

    check.py PROJECT.xml [PATH VALUE...]      e.g. check.py ../04-office/project.xml linear.flux-lm 3000 4000 5000
"""
import sys

import luxgate
import numpy as np


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    project, path, values = sys.argv[1], *(sys.argv[2:3] or [""]), sys.argv[3:]
    try:
        result = luxgate.check(project)
    except luxgate.CheckError as error:
        sys.exit(str(error))
    print(f"{project}: {result.verdict}")
    for finding in result.findings:
        if finding.outcome == "pass":
            continue
        measured = "-" if finding.measured is None else f"{finding.measured.value:.4g} {finding.unit}"
        print(f"  {finding.space}/{finding.plane} {finding.words}: {finding.verdict}, {measured}, limit {finding.limit}; {finding.reason}")
    for plane in result.planes:
        if plane.is_computed:
            darkest = int(np.argmin(plane.values))
            place = ", ".join(f"{metres:.2f}" for metres in plane.points[darkest])
            print(f"  {plane.space}/{plane.id}: least {plane.values[darkest]:.4g} {plane.unit} at ({place}) m")
    for value in values:
        variant = luxgate.check(project, set={path: value})
        averages = [plane.statistics.average_lx.value for plane in variant.planes if plane.is_computed and plane.unit == "lx"]
        print(f"  {path}={value}: {variant.verdict}, averages " + ", ".join(f"{average:.4g} lx" for average in averages))
    return result.exit_code


if __name__ == "__main__":
    sys.exit(main())
