"""A small design, for tests of revisions: two rows of luminaires, a plane that is met with room to spare, one that is not."""
PHOTOMETRY = """IESNA:LM-63-2002
[TEST] none
[MANUFAC] luxgate tests
TILT=NONE
1 -1 1 7 1 1 2 0 0 0
1 1 30
0 15 30 45 60 75 90
0
{candela}
"""
CANDELA = "1000 960 860 700 480 240 0"
# Met with room to spare: average. Not met: minimum of the far plane.
PROJECT = """<luxgate version="1" name="{name}" maintenance-factor="{mf}">
<material id="light" reflectance="0.7"/><material id="dark" reflectance="0.3"/>
<luminaire-type id="spot" photometry="spot.ies"{flux}/>
<room id="{room_id}"{was_room} name="{room}" size="5 4 2.8" ceiling="light" walls="light" floor="dark">
<luminaire-grid id="L" type="spot" origin="0 0 2.79" size="5 4" columns="{columns}" rows="2"/>
<plane id="{plane}"{was_plane} origin="1 1 0.8" u="{width} 0 0" v="0 2 0" margin="{margin}" count="{points} 4">
<require id="mean" quantity="average" at-least="{limit}"/></plane>
{far}
</room></luxgate>
"""
FAR = """<plane id="far" origin="0.2 0.2 0.1" u="4.6 0 0" v="0 3.6 0" count="5 5">
<require id="least" quantity="minimum" at-least="2000"{far_waiver}/></plane>"""
USUAL = dict(name="Design", room_id="room", was_room="", was_plane="", mf="0.8", flux="", room="Office", columns=3, plane="desk", width="3", margin="0", points=6,
             limit="100", far_waiver="")
WAIVER = ' waived-because="client" waived-by="A. Meier" waived-until="2099-12-31"'


def project(far=True, **changes):
    values = {**USUAL, **changes}
    values["far"] = FAR.format(**values) if far else ""
    return PROJECT.format(**values)


def write(file, candela=CANDELA, **changes):
    """Writes the project and its photometry beside it."""
    file.parent.mkdir(parents=True, exist_ok=True)
    (file.parent / "spot.ies").write_text(PHOTOMETRY.format(candela=candela))
    file.write_text(project(**changes))
    return str(file)
