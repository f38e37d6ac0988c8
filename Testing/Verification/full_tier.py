"""The full tier: every count that the issues state, on the real CTs; called by Testing/run.sh --full.

With --quick NAME, one real case on a coarse mesh for the quick tier; exit 77 where the data is absent.

A check is a function that returns rows (name, value, requirement, pass). Finished checks are kept in the
work folder together with a checksum of the program and are not run again while that stays the same.
"""
import argparse
import array
import concurrent.futures
import gzip
import hashlib
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

here = pathlib.Path(__file__).resolve().parent
cases = here.parent / "Data"

# Of the mid-face, right, anterior, superior, pitch, roll, yaw in mm and degrees: what plain tetrahedra
# with ccx's quadratic volumetric law bear in these equal increments, by both engines.
CALCULIX_MOVEMENT = "1,4,-2,2,1,0"
CALCULIX_INCREMENTS = 4


class Missing(Exception):
    """The check cannot be done here, and why."""


class Tier:
    def __init__(self, program, data, work, density=None):
        self.density = density
        self.program = program.resolve()
        self.data = data.resolve()
        self.work = work.resolve()
        self.work.mkdir(parents=True, exist_ok=True)
        self.build = hashlib.sha256(self.program.read_bytes()).hexdigest()[:8]

    def run(self, *arguments, threads=None):
        environment = dict(os.environ, FACETOBONE_DATA=str(self.data))
        if threads:
            environment.update(OMP_NUM_THREADS=str(threads), OPENBLAS_NUM_THREADS=str(threads))
        begin = time.monotonic()
        done = subprocess.run([str(self.program), "-q", *map(str, arguments)], env=environment,
                              capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(f"exit {done.returncode}: {done.stderr.strip()}")
        return time.monotonic() - begin

    def tool(self, name):
        """A program of the build besides facetobone, by its path there."""
        return self.program.parent.parent / "Testing" / name

    def real_case(self, name):
        if not (self.data / name).exists():
            raise Missing(f"no {self.data / name}: set FACETOBONE_DATA")
        case = cases / f"{name}.json"
        if not self.density:
            return case
        coarse = load(case)
        coarse["mesh"] = {"density": self.density}
        coarse["landmarks"] = str(cases / coarse["landmarks"])
        copy = self.work / f"{name}-coarse.json"
        copy.write_text(json.dumps(coarse))
        return copy

    def planned(self, name, threads=None):
        """A whole run of a case of Testing/Data; one folder a case and number of threads."""
        folder = self.work / (name + (f"-{threads}" if threads else ""))
        seconds = self.run("run", self.real_case(name), "-o", folder, threads=threads)
        return folder, seconds


def load(path):
    return json.loads(path.read_text())


def rotation_matrix(degrees):
    p, r, y = (math.radians(degrees.get(k, 0)) for k in ("pitch", "roll", "yaw"))
    cp, sp, cr, sr, cy, sy = math.cos(p), math.sin(p), math.cos(r), math.sin(r), math.cos(y), math.sin(y)
    return [[cy * cr, cy * sr * sp - sy * cp, cy * sr * cp + sy * sp],
            [sy * cr, sy * sr * sp + cy * cp, sy * sr * cp - cy * sp],
            [-sr, cr * sp, cr * cp]]


def angle_between(a, b):
    """Of two 3 x 3 rotations [degrees]."""
    trace = sum(a[k][i] * b[k][i] for i in range(3) for k in range(3))
    return math.degrees(math.acos(max(-1.0, min(1.0, (trace - 1) / 2))))


def movement_errors(plan, stated, method="rigid-fit"):
    """Largest translation [mm] and rotation [degrees] error over the fragments."""
    millimetres = degrees = 0.0
    for fragment in plan["methods"][method]["fragments"]:
        truth = stated[fragment["name"]]
        t = truth.get("translation_mm", {})
        millimetres = max(millimetres, math.dist(
            [fragment["translation_mm"][k] for k in ("right", "anterior", "superior")],
            [t.get(k, 0) for k in ("right", "anterior", "superior")]))
        found = [fragment["matrix_ras"][4 * r:4 * r + 3] for r in range(3)]
        degrees = max(degrees, angle_between(found, rotation_matrix(truth.get("rotation_deg", {}))))
    return millimetres, degrees


def real_ct(tier, name):
    folder, seconds = tier.planned(name)
    plan, mesh = load(folder / "plan.json"), load(folder / "mesh.json")
    stated = load(cases / f"{name}.json")["target"]["from_movement"]
    millimetres, degrees = movement_errors(plan, stated)
    biased, _ = movement_errors(plan, stated, "virtual-force")
    timing = plan["timing_s"]
    preparation = timing["segment"] + timing["cut"] + timing["mesh"]
    volume = abs(mesh["mesh_volume_mm3"] / mesh["label_volume_mm3"] - 1)
    memory = plan["peak_rss_mb"] / 1024
    p95 = max(mesh["skin_to_ct_mm"]["p95"], mesh["ct_to_skin_mm"]["p95"])
    far = max((mesh["skin_to_ct_mm"], mesh["ct_to_skin_mm"]), key=lambda d: d["max"])
    alone = not tier.density  # the quick tier shares its cores: times are printed, not judged
    rows = [
        ("whole run [s]", seconds, "< 300" if alone else "printed", not alone or seconds < 300),
        ("segment + cut + mesh [s]", preparation, "< 60" if alone else "printed", not alone or preparation < 60),
        ("peak memory [GiB]", memory, "< 6", memory < 6),
        ("smallest dihedral angle [deg]", mesh["min_dihedral_deg"], ">= 8", mesh["min_dihedral_deg"] >= 8),
        ("smallest scaled Jacobian", mesh["min_prism_scaled_jacobian"], ">= 0.1",
         mesh["min_prism_scaled_jacobian"] >= 0.1),
        ("inverted elements", mesh["inverted_elements"], "0", mesh["inverted_elements"] == 0),
        ("prisms without their tetrahedron", mesh["unmatched_inner_faces"], "0",
         mesh["unmatched_inner_faces"] == 0),
        ("holes in the skin", mesh["holes"], "0", mesh["holes"] == 0),
        ("volume, mesh against labels", volume, "< 0.02", volume < 0.02),
        ("skin distance p95, both ways [mm]", p95, "< 0.5", p95 < 0.5),
        ("skin distance p99.5 [mm]", max(mesh["skin_to_ct_mm"]["p99.5"], mesh["ct_to_skin_mm"]["p99.5"]), "printed", True),
        ("skin distance max [mm] at RAS " + " ".join(f"{c:.0f}" for c in far["max_at_ras"]), far["max"], "printed", True),
        ("rigid-fit translation error [mm]", millimetres, "< 0.05", millimetres < 0.05),
        ("rigid-fit rotation error [deg]", degrees, "< 0.05", degrees < 0.05),
        ("virtual-force translation error [mm]", biased, "printed", True),
        ("report.html", int((folder / "report.html").exists()), "1", (folder / "report.html").exists()),
    ]
    if name == "cthead_unc" and not tier.density:
        rows += [("prisms", mesh["prisms"], ">= 9000", mesh["prisms"] >= 9000),
                 ("tetrahedra", mesh["tets"], ">= 100000", mesh["tets"] >= 100000)]
    return rows


def movements(tier):
    """Movements of 0 to 22 mm, forwards and downwards as mid-faces go, then back from the face."""
    folder = tier.work / "cthead_unc"
    if not (folder / "mesh.vtu").exists():
        folder, _ = tier.planned("cthead_unc")
    case = tier.work / "cthead_unc-movements"
    shutil.rmtree(case, ignore_errors=True)
    shutil.copytree(folder, case)
    rows = []
    for millimetres in (0, 1, 4, 8, 12, 17, 22):
        share = millimetres / math.sqrt(2 ** 2 + 11 ** 2 + 5 ** 2)
        values = [2 * share, 11 * share, -5 * share, 5 * min(share, 2), 2.5 * min(share, 2), 0]
        argument = "mid-face:" + ",".join(f"{v:.6f}" for v in values)
        tier.run("target", case, "--movement", argument)
        tier.run("plan", case)
        stated = load(case / "case.json")["target"]["from_movement"]
        error, degrees = movement_errors(load(case / "plan.json"), stated)
        rows.append((f"{millimetres} mm: found back within [mm]", error, "< 0.05", error < 0.05))
        rows.append((f"{millimetres} mm: found back within [deg]", degrees, "< 0.05", degrees < 0.05))
    return rows


def forward_solve(tier):
    """Table 2's movement at reference size: cost of one NFM-EM solve, and the creases of the skin."""
    folder = tier.work / "cthead_unc"
    if not (folder / "mesh.vtu").exists():
        folder, _ = tier.planned("cthead_unc")
    done = subprocess.run([tier.tool("Verification/forward_solve"), folder], capture_output=True, text=True,
                          env=dict(os.environ, FACETOBONE_DATA=str(tier.data)), check=True)
    told = json.loads(done.stdout)
    crease = told["crease"]
    rows = [("prisms", told["prisms"], "printed", True),
            ("tetrahedra", told["tets"], ">= 100000", told["tets"] >= 100000),
            ("converged", int(told["converged"]), "1", told["converged"]),
            ("solve [s]", told["seconds"], "< 15", told["seconds"] < 15),
            ("peak memory [GiB]", told["peak_gib"], "< 4", told["peak_gib"] < 4),
            ("numeric factorisations", told["factorizations"], "<= 8", told["factorizations"] <= 8),
            ("Newton iterations", told["newton_iterations"], "printed", True),
            ("iterations of conjugate gradients", told["cg_iterations"], "printed", True)]
    rows += [(f"time in {part} [s]", seconds, "printed", True) for part, seconds in told["time_s"].items()]
    rows += [("factorisation [GFlop/s]", told["factorization_gflops"], "printed", True),
             ("dgemm [GFlop/s]", told["dgemm_gflops"], "printed", True)]
    rows += [(f"crease, {kind.replace('_', ' ')}, mean [deg]", crease[kind]["mean_deg"], "printed", True)
             for kind in ("linear_at_rest", "smooth_at_rest", "linear_deformed", "smooth_deformed")]
    return rows + [("prisms with straight edges", crease["folded_prisms"], "printed", True)]


def meshed_head(tier):
    folder = tier.work / "cthead_unc"
    if not (folder / "mesh.vtu").exists():
        folder, _ = tier.planned("cthead_unc")
    return folder


def told_by(tier, tool, *arguments):
    """What a program of Testing/Verification prints as JSON."""
    done = subprocess.run([tier.tool(f"Verification/{tool}"), *map(str, arguments)], capture_output=True, text=True,
                          env=dict(os.environ, FACETOBONE_DATA=str(tier.data)))
    if done.returncode == 77:
        raise Missing(done.stderr.strip())
    if not done.stdout:
        raise RuntimeError(done.stderr.strip())
    return json.loads(done.stdout)


def mtm_lfem(tier):
    """Table 2's movement by the four models: the mass tensors come to rest where LFEM is."""
    told = told_by(tier, "compare_models", meshed_head(tier))
    apart = told["mtm_from_lfem"]
    rows = [("tetrahedra, prisms split", told["split_tets"], "printed", True),
            ("mtm from lfem, RMS of the largest displacement", apart["rms"], "< 0.01", apart["rms"] < 0.01),
            ("mtm from lfem, largest", apart["max"], "< 0.01", apart["max"] < 0.01),
            ("mtm at rest", int(told["mtm"]["converged"]), "1", told["mtm"]["converged"]),
            ("mtm steps", told["mtm"]["steps"], "printed", True),
            ("nfem from lfem, RMS", told["nfem_from_lfem"]["rms"], "printed", True),
            ("nfm-em from nfem, RMS", told["nfm-em_from_nfem"]["rms"], "printed", True)]
    return rows + [(f"{model} [s]", told[model]["seconds"], "printed", True)
                   for model in ("lfem", "mtm", "nfem", "nfm-em")]


def calculix(tier):
    """The same tetrahedra, law, increments and tolerance by ccx and by us, on the real head."""
    told = told_by(tier, "compare_calculix", meshed_head(tier), cases / "table1-stable-quadratic.json",
                   CALCULIX_MOVEMENT, CALCULIX_INCREMENTS, tier.work / "calculix")
    ccx, ours, alone, apart = told["ccx"], told["ours"], told["ours_in_one_increment"], told["difference"]
    print(f"deck {told['deck']}, ccx {ccx['version']}", flush=True)
    return [("tetrahedra", told["tets"], ">= 100000", told["tets"] >= 100000),
            ("increments", told["increments"], "printed", True),
            ("largest displacement [mm]", apart["largest_displacement_mm"], "printed", True),
            ("displacements apart, RMS of the largest", apart["rms_relative"], "< 0.005", apart["rms_relative"] < 0.005),
            ("displacements apart, largest", apart["max_relative"], "printed", True),
            (f"ccx {ccx['version']} [s]", ccx["wall_s"], "printed", True),
            ("ccx, iterations", ccx["iterations"], "printed", True),
            ("ours, same increments [s]", ours["wall_s"], "printed", True),
            ("ours, iterations", ours["newton_iterations"], "printed", True),
            ("ours, numeric factorisations", ours["factorizations"], "printed", True),
            ("ours, residual in ccx's measure", ours["residual"], "< 1e-6", ours["residual"] < 1e-6),
            ("times faster than ccx", told["times_faster"], ">= 8", told["times_faster"] >= 8),
            ("times less processor time", told["times_faster_processor"], "printed", True),
            ("ours, own increments [s]", alone["wall_s"], "printed", True),
            ("times faster, own increments", told["times_faster_in_one_increment"], "printed", True)]


def benchmarks(tier):
    """Growth of time and memory from 30 000 to 400 000 tetrahedra, and the ratio to a named peer."""
    done = subprocess.run([tier.tool("Benchmarks/benchmark_mechanics"), "--benchmark_color=false"],
                          capture_output=True, text=True, check=True)
    print(done.stdout, flush=True)
    rows = []
    for line in done.stdout.splitlines():
        growth = re.match(r"growth of (\S+)\s+time ~ tets\^([\d.]+)(?:, memory ~ tets\^([\d.]+))?", line)
        if growth:
            rows.append((f"{growth[1]}: exponent of time", float(growth[2]), "printed", True))
            if growth[3]:
                rows.append((f"{growth[1]}: exponent of memory", float(growth[3]), "printed", True))
        ratio = re.match(r"(.*): ([\d.]+) times faster than by (\S+)", line)
        if ratio:
            rows.append((f"{ratio[1]}, times faster than {ratio[3]}", float(ratio[2]), "> 1", float(ratio[2]) > 1))
    if len(rows) < 5:
        raise RuntimeError("the benchmarks printed no growth")
    return rows


def scenes(tier):
    """MRML scenes: 1000 damaged files, and a big scene's times against plain copies on the same disk."""
    folder = tier.tool("MRML/StandIn")
    done = subprocess.run([folder / "test_mrml_mutations"], capture_output=True, text=True,
                          env=dict(os.environ, F2B_MUTATIONS="1000"))
    damaged = re.search(r"(\d+) damaged files", done.stdout)
    times = json.loads(subprocess.run([folder / "scene_times", tier.work], capture_output=True, text=True,
                                      check=True).stdout)
    return [("damaged files, none of which crashed", int(damaged[1]) if damaged else 0, "1000",
             damaged is not None and int(damaged[1]) == 1000 and done.returncode == 0),
            ("scene [MB]", times["megabytes"], "printed", True),
            ("plain copies, written and read [s]", times["raw_s"], "printed", True),
            ("scene saved [s]", times["save_s"], "printed", True),
            ("scene loaded [s]", times["load_s"], "printed", True),
            ("scene's times to the copies'", times["ratio"], "<= 2", times["ratio"] <= 2)]


def sanitizers(tier):
    """The whole Core test suite under ASan and UBSan."""
    root = here.parent.parent
    build = root / ".build" / "asan"
    for command in (["cmake", "--preset", "asan"], ["cmake", "--build", "--preset", "asan", "--target", "core_tests"]):
        subprocess.run(command, cwd=root, capture_output=True, text=True, check=True)
    done = subprocess.run(["ctest", "--test-dir", build / "Testing" / "Logic" / "Core", "-j2", "--timeout", "1800"],
                          capture_output=True, text=True)
    summary = re.search(r"(\d+) tests failed out of (\d+)", done.stdout)
    if not summary:
        raise RuntimeError(done.stdout[-500:] + done.stderr[-500:])
    failed, count = int(summary[1]), int(summary[2])
    if failed:
        print(done.stdout, flush=True)
    return [("Core tests under ASan and UBSan", count, "> 100", count > 100),
            ("of these failed", failed, "0", failed == 0)]


ROBUSTNESS = ("RobustWindow.*:CutsWindow.CutsGone*:CutsWindow.StepsInEveryOrder*:CutsWindow.RandomEvents*:"
              "MainWindow.AnotherCase*:MainWindow.Cancelled*:MainWindow.ClosingDuring*:MainWindow.Menus*")


def window_patient(tier):
    """What Testing/Widgets/desktop_patient.hpp makes; under sanitizers it would take half an hour."""
    folder = tier.work / "window-events"
    shutil.rmtree(folder, ignore_errors=True)
    tier.run("sample", "-o", folder / "patient")
    case = load(folder / "patient" / "case.json")
    case.setdefault("mesh", {})["density"] = 0.15
    case.setdefault("solver", {})["max_fit_iterations"] = 2
    (folder / "patient" / "case.json").write_text(json.dumps(case))
    tier.run("segment", folder / "patient" / "case.json", "-o", folder / "segmented")
    return folder


def passed_by(program, chosen, **environment):
    """How many tests of a program passed; None if one failed or the program did not end well."""
    done = subprocess.run([program, f"--gtest_filter={chosen}"], capture_output=True, text=True,
                          env=dict(os.environ, **environment))
    passed = re.search(r"\[  PASSED  \] (\d+) tests?", done.stdout)
    if done.returncode or not passed:
        print(done.stdout[-2000:] + done.stderr[-2000:], flush=True)
        return None
    return int(passed[1])


def window_events(tier):
    """10 000 random events for each 3D tool, and the window's tests of robustness, under ASan and UBSan."""
    root = here.parent.parent
    for command in (["cmake", "--preset", "asan"],
                    ["cmake", "--build", "--preset", "asan", "--target", "test_tools", "test_cuts", "test_main_window"]):
        subprocess.run(command, cwd=root, capture_output=True, text=True, check=True)
    widgets = root / ".build" / "asan" / "Testing" / "Widgets"
    many = {"FACETOBONE_RANDOM_EVENTS": "10000"}
    # the drivers of OpenGL keep what they have until the program ends
    sanitized = {"ASAN_OPTIONS": "detect_leaks=0", "UBSAN_OPTIONS": "print_stacktrace=1"}
    tools = passed_by(widgets / "test_tools", "*Random*", **many, **sanitized)
    at_cuts = passed_by(tier.tool("Widgets/test_main_window"), "*Random*", FACETOBONE_PROGRAM=str(tier.program), **many)
    robust = passed_by(widgets / "test_main_window", ROBUSTNESS, FACETOBONE_TEST_PATIENT=str(window_patient(tier)),
                       FACETOBONE_PROGRAM=str(tier.program), **sanitized)
    return [("tools with 10 000 random events each under ASan and UBSan", tools or 0, ">= 6", (tools or 0) >= 6),
            ("window with 10 000 random events at face and cuts", at_cuts or 0, ">= 2", (at_cuts or 0) >= 2),
            ("window's tests of robustness under ASan and UBSan", robust or 0, ">= 12", (robust or 0) >= 12)]


def reproducible(tier):
    def stripped(folder):
        plan = load(folder / "plan.json")
        plan.pop("timing_s"), plan.pop("peak_rss_mb")
        return plan

    name = "cthead_unc"
    first, _ = tier.planned(name, threads=2)
    before, mesh_before = stripped(first), (first / "mesh.vtu").read_bytes()
    second, _ = tier.planned(name, threads=2)
    again = stripped(second)
    one, _ = tier.planned(name, threads=1)
    alone = stripped(one)
    millimetres = degrees = 0.0
    for method in before["methods"]:
        for a, b in zip(before["methods"][method]["fragments"], alone["methods"][method]["fragments"]):
            millimetres = max(millimetres, *(abs(a["translation_mm"][k] - b["translation_mm"][k]) for k in a["translation_mm"]))
            degrees = max(degrees, *(abs(a["rotation_deg"][k] - b["rotation_deg"][k]) for k in a["rotation_deg"]))
    same_mesh = mesh_before == (one / "mesh.vtu").read_bytes()
    return [("plan.json twice the same", int(before == again), "1", before == again),
            ("mesh the same with 1 and 2 threads", int(same_mesh), "1", same_mesh),
            ("movements, 1 against 2 threads [mm]", millimetres, "< 1e-6", millimetres < 1e-6),
            ("movements, 1 against 2 threads [deg]", degrees, "< 1e-6", degrees < 1e-6)]


def meshed_sample(tier, density):
    """The virtual patient, segmented, cut and meshed."""
    sample, folder = tier.work / "sample", tier.work / "sample-meshed"
    tier.run("sample", "-o", sample)
    case = load(sample / "case.json")
    case["mesh"] = {"density": tier.density or density}
    (sample / "meshed.json").write_text(json.dumps(case))
    tier.run("segment", sample / "meshed.json", "-o", folder)
    tier.run("cut", folder)
    tier.run("mesh", folder)
    return folder


def random_movements(tier):
    """Seeded random movements of the sample's mid-face; those into uncut bone are left out (movement_sampler.hpp)."""
    folder = meshed_sample(tier, 0.6)  # the virtual head is large: this is the reference size, 110k tets
    parts = [tier.work / f"random_movements-{i}.json" for i in range(2)]
    one_thread = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    running = []
    for i, part in enumerate(parts):
        own = part.with_suffix("")  # a case serves one process at a time
        shutil.rmtree(own, ignore_errors=True)
        shutil.copytree(folder, own)
        running.append(subprocess.Popen([tier.tool("Verification/random_movements"), own,
                                         "6" if tier.density else "200", part, str(i), str(len(parts))],
                                        env=one_thread))
    exits = [process.wait() for process in running]
    if any(exits):
        raise RuntimeError(f"exits {exits}")
    told = load(parts[0])
    movements = [movement for part in parts for movement in load(part)["movements"]]
    count = len(movements)
    converged = sum(m["converged"] for m in movements)
    small = [m for m in movements if m["translation_mm"] < 12 and m["rotation_deg"] < 6]
    small_lost = sum(not m["converged"] for m in small)
    mute = sum(not m["converged"] and "could follow only" not in m["sentence"] for m in movements)
    # a state that is not finite has no dilatation (null)
    inverted = sum(not m["finite"] or not m["smallest_dilatation"] > 0 for m in movements)
    seconds = [m["seconds"] for m in movements]
    return [("movements", count, "printed", True),
            ("left out, into uncut bone", told["left_out_into_uncut_bone"], "printed", True),
            ("share that converged", converged / count, ">= 0.95", converged >= 0.95 * count),
            ("under 12 mm and 6 degrees", len(small), "> 0", len(small) > 0),
            ("of these not converged", small_lost, "0", small_lost == 0),
            ("stopped without the sentence", mute, "0", mute == 0),
            ("states with NaN or an inverted element", inverted, "0", inverted == 0),
            ("smallest det F", min(m["smallest_dilatation"] for m in movements), "> 0", inverted == 0),
            ("mean time of a solve, one thread [s]", sum(seconds) / count, "printed", True),
            ("longest solve, one thread [s]", max(seconds), "printed", True)]


MISMATCHED_CASES = 20  # seeds; the issue asks for at least so many
NEAR_MM = 0.5  # of the bone, when the patient is not as the plan believes
PAPER_TABLE_4 = {"S1": 1.87, "S2": 1.58}


def landmarks_ras(path):
    """Of a Slicer fiducial file in LPS."""
    return {p["label"]: [-p["position"][0], -p["position"][1], p["position"][2]]
            for p in load(path)["markups"][0]["controlPoints"]}


def midline_plane(path, landmarks):
    """A cut between the halves of the upper jaw, from the teeth to above the floor of the nose."""
    low, high = landmarks["U1"][2] - 4, landmarks["ANS"][2] + 8
    centre = [-landmarks["ANS"][0], -(landmarks["ANS"][1] + landmarks["PNS"][1]) / 2, (low + high) / 2]
    path.write_text(json.dumps({"markups": [{
        "type": "Plane", "name": "midline", "coordinateSystem": "LPS", "planeType": "pointNormal",
        "center": centre, "orientation": [0, 0, -1, -1, 0, 0, 0, 1, 0], "size": [120, high - low, 0],
        "controlPoints": []}]}))
    return str(path)


def osteotomies(fragments, landmarks, folder):
    """Cuts that free so many fragments."""
    if fragments == 1:
        return [{"fragment": "mid-face", "template": "le-fort-3"}]
    jaws = [{"fragment": "mandible", "template": "bsso"}, {"fragment": "chin", "template": "genioplasty"}]
    if fragments < 4:
        return [{"fragment": "maxilla", "template": "le-fort-1"}] + jaws[3 - fragments:]

    def tooth(name):
        return [landmarks[name][0], landmarks[name][1], landmarks[name][2] + 8]

    return [{"fragment": "maxilla right", "template": "le-fort-1", "fragment_point_ras": tooth("U6_R")},
            {"fragment": "maxilla left", "planes": [midline_plane(folder / "midline.mrk.json", landmarks)],
             "fragment_point_ras": tooth("U6_L")}] + jaws


def cut_head(tier, name, fragments, density):
    """The sample or a real head, cut into so many fragments and meshed."""
    if name == "sample":
        source = tier.work / "sample"
        if not (source / "case.json").exists():
            tier.run("sample", "-o", source)
        case = load(source / "case.json")
        case["ct"] = str(source / case["ct"])
        case["landmarks"] = str(source / case["landmarks"])
        for end in ("from", "to"):
            case["target"]["warp"][end] = str(source / case["target"]["warp"][end])
    else:
        case = load(tier.real_case(name))
        case["landmarks"] = str(cases / case["landmarks"])
    folder = tier.work / f"{name}-{fragments}-{density}-{tier.build}"  # what another program made is stale
    if (folder / "mesh.vtu").exists():
        return folder
    case["osteotomies"] = osteotomies(fragments, landmarks_ras(pathlib.Path(case["landmarks"])), tier.work)
    if name != "sample":
        case["target"] = {"from_movement": {case["osteotomies"][0]["fragment"]: {"translation_mm": {"anterior": 5}}}}
    case["mesh"] = {"density": density}
    written = tier.work / f"{name}-{fragments}.json"
    written.write_text(json.dumps(case))
    for verb, *arguments in (("segment", written, "-o", folder), ("cut", folder), ("mesh", folder)):
        tier.run(verb, *arguments)
    return folder


def in_two_processes(commands, environment):
    """Runs commands two at a time, one thread each."""
    waiting, running = list(commands), []
    environment = dict(environment, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    while waiting or running:
        while waiting and len(running) < 2:
            running.append(subprocess.Popen([str(word) for word in waiting.pop(0)], env=environment,
                                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True))
        time.sleep(0.2)
        for process in [process for process in running if process.poll() is not None]:
            running.remove(process)
            if process.returncode:
                raise RuntimeError(f"exit {process.returncode}: {process.stderr.read().strip()}")


def own_copies(tier, folder):
    """A case serves one process at a time: two copies of it."""
    copies = []
    for i in range(2):
        copy = tier.work / f"{folder.name}-copy{i}"
        shutil.rmtree(copy, ignore_errors=True)
        shutil.copytree(folder, copy)
        copies.append(copy)
    return copies


def mismatched_truth(tier):
    """Plans for patients who are not as the plan believes, one process a seed; finished seeds are kept."""
    count = 1 if tier.density else MISMATCHED_CASES
    folder = cut_head(tier, "sample", 1, 0.1 if tier.density else 0.15)
    program = tier.tool("Verification/mismatched_truth")
    stamp = hashlib.sha256(program.read_bytes()).hexdigest()[:8]
    results = [tier.work / f"mismatched-{stamp}-{seed}.json" for seed in range(1, count + 1)]
    missing = [(seed, result) for seed, result in enumerate(results, 1) if not result.exists()]
    copies = own_copies(tier, folder)
    halves = [[f"{program} {copies[i]} {seed} {result}" for seed, result in missing[i::2]] for i in range(2)]
    in_two_processes([["bash", "-ec", "; ".join(half)] for half in halves if half],
                     dict(os.environ, FACETOBONE_DATA=str(tier.data)))
    told = [load(result) for result in results]

    def mean(values):
        values = list(values)
        return sum(values) / len(values)

    rigid, dragged = mean(t["rigid_fit_mm"] for t in told), mean(t["virtual_force_mm"] for t in told)
    cases_mm = sorted(t["rigid_fit_mm"] for t in told)
    rows = [("cases", count, ">= 20" if not tier.density else "printed", True),
            ("tetrahedra, plan / truth", told[0]["tetrahedra"]["plan"], "printed", True),
            ("tetrahedra of the truth", told[0]["tetrahedra"]["truth"], "printed", True),
            ("bone travels, mean [mm]", mean(t["bone_travel_mm"] for t in told), "printed", True)]
    rows += [(f"bone error by {cause.replace('_', ' ')}, mean [mm]", mean(t["causes_mm"][cause] for t in told), "printed", True)
             for cause in told[0]["causes_mm"]]
    rows += [(f"all causes, {noise.replace('_', ' ')}, mean [mm]", mean(t["totals_mm"][noise] for t in told), "printed", True)
             for noise in told[0]["totals_mm"]]
    rows += [("rigid-fit, all causes, mean bone error [mm]", rigid, f"< {NEAR_MM}", rigid < NEAR_MM),
             ("rigid-fit, median case [mm]", cases_mm[count // 2], "printed", True),
             ("rigid-fit, worst case [mm]", cases_mm[-1], "printed", True),
             ("virtual-force, the same targets [mm]", dragged, "printed", True),
             ("virtual-force over rigid-fit", dragged / rigid, ">= 3", dragged >= 3 * rigid)]
    return rows + [(f"paper's Table 4, {name} [mm]", value, "printed", True) for name, value in PAPER_TABLE_4.items()]


def recovery(tier):
    """Movements of 1 to 4 fragments found back from the faces that they give, exact and with 0.5 mm of noise."""
    rows = []
    heads = ["sample"] if tier.density else ["sample", "cthead_unc"]
    commands, results = [], []
    program = tier.tool("Verification/recovery")
    stamp = hashlib.sha256(program.read_bytes()).hexdigest()[:8]
    for name in heads:
        for fragments in (1, 2) if tier.density else (1, 2, 3, 4):
            folder = cut_head(tier, name, fragments, 0.1 if name == "sample" else 0.25)
            result = tier.work / f"recovery-{stamp}-{name}-{fragments}.json"
            results.append((f"{name}, {fragments} fragments", result))
            if not result.exists():
                commands.append([program, folder, 100 + fragments, 1 if tier.density else 3, result])
    in_two_processes(commands, dict(os.environ, FACETOBONE_DATA=str(tier.data)))
    for what, result in results:
        told = load(result)
        movements = told["movements"]
        millimetres = max(m["exact"]["mm"] for m in movements)
        degrees = max(m["exact"]["deg"] for m in movements)
        noisy = max(m["noise"]["bone_mm"] for m in movements)
        rows += [(f"{what}: movements", len(movements), "printed", True),
                 (f"{what}: drawn, but the tissue cannot follow", told["not_followed"], "printed", True),
                 (f"{what}: longest [mm]", max(m["longest_mm"] for m in movements), "printed", True),
                 (f"{what}: widest [deg]", max(m["widest_deg"] for m in movements), "printed", True),
                 (f"{what}: found back within [mm]", millimetres, "< 0.05", millimetres < 0.05),
                 (f"{what}: found back within [deg]", degrees, "< 0.05", degrees < 0.05),
                 (f"{what}: bone off with 0.5 mm of white noise [mm]", noisy, "< 0.2", noisy < 0.2),
                 (f"{what}: the same, noise over 5 mm [mm]", max(m["noise_over_5_mm"]["bone_mm"] for m in movements),
                  "printed", True)]
    return rows


def plan_time(tier):
    """A plan at reference size with one, two and four fragments, and its live operator."""
    rows = []
    for fragments in (1, 2, 4):
        told = told_by(tier, "plan_time", cut_head(tier, "cthead_unc", fragments, tier.density or 1))
        fit, drag, live = told["rigid_fit"], told["virtual_force"], told["live"]
        what = f"{fragments} fragments: "
        rows += [(what + "tetrahedra", told["tets"], ">= 100000", bool(tier.density) or told["tets"] >= 100000),
                 (what + "rigid-fit [s] (aim 30)", fit["seconds"], "printed", True),
                 (what + "rigid-fit, processor time of all threads [s]", fit["processor_s"], "printed", True),
                 (what + "converged", int(fit["converged"]), "1", fit["converged"]),
                 (what + "numeric factorisations", fit["factorizations"], "printed", True)]
        rows += [(what + f"time in {part} [s]", seconds, "printed", True) for part, seconds in fit["split_s"].items()]
        rows += [(what + "virtual-force [s]", drag["seconds"], "printed", True),
                 (what + "live operator, prepared in [s] (aim 10)", live["prepare_s"], "printed", True),
                 (what + "live operator, an update [ms] (aim 20)", live["update_ms"], "printed", True),
                 (what + "live plan from the full one, a tenth off [mm]", live["a_tenth_off"]["bone_from_full_plan_mm"],
                  "printed", True)]
    return rows


def postoperative(tier):
    """What happened is found again in a CT that is made of it, resliced and with noise."""
    work = tier.work / "postoperative"
    shutil.rmtree(work, ignore_errors=True)
    folder = cut_head(tier, "cthead_unc", 1, 0.25)
    done = subprocess.run([tier.tool("Verification/postoperative"), folder, work], capture_output=True, text=True,
                          env=dict(os.environ, FACETOBONE_DATA=str(tier.data)))
    if done.returncode:
        raise RuntimeError(done.stderr.strip())
    rows = []
    for i, told in enumerate(load(work / "postoperative.json"), 1):
        bone = max(f["largest_mm"] for f in told["fragments"])
        rows += [(f"reslice {i}: registration off by [mm]", told["registration_largest_mm"], "< 0.3",
                  told["registration_largest_mm"] < 0.3),
                 (f"reslice {i}: registration off by [deg]", told["registration_deg"], "< 0.3", told["registration_deg"] < 0.3),
                 (f"reslice {i}: bone movement off by, at most [mm]", bone, "< 0.5", bone < 0.5)]
    seconds = tier.run("evaluate", folder, "--experiments", "1,2", "--postoperative", work / "after.nrrd")
    told = load(folder / "evaluation" / "evaluation.json")
    s2 = told["experiment2"]["rows"][1]["methods"]
    return rows + [("evaluate --postoperative [s]", seconds, "printed", True),
                   ("S2 on its skin, rigid-fit, bone error [mm]", s2["rigid-fit"]["bone_error_mm"]["mean"], "printed", True),
                   ("S2 on its skin, virtual-force [mm]", s2["virtual-force"]["bone_error_mm"]["mean"], "printed", True)]


def experiments(tier, name):
    """The paper's three experiments by one command; figures are printed, what must hold is required."""
    folder = cut_head(tier, name, 1, {"sample": 0.6}.get(name, 1))
    kept = folder / "evaluation" / "evaluation.json"
    seconds = load(kept)["seconds"] if kept.exists() else tier.run("evaluate", folder)
    told = load(kept)
    rows = [("evaluate [s]", seconds, "printed", True)]
    for r in told["experiment1"]["rows"]:
        rows += [(f"experiment 1, {r['model']}: {key} [mm] (paper {r['paper_mm'][key]})", r["error_mm"][key], "printed", True)
                 for key in ("mean", "variance", "max")]
    for r in told["experiment2"]["rows"]:
        for method, found in r["methods"].items():
            rows.append((f"experiment 2, {r['name']}, {method}: mean bone error [mm] (paper {r['paper_mm']['mean']})",
                         found["bone_error_mm"]["mean"], "printed", True))
    s2 = told["experiment2"]["rows"][1]
    near = s2["methods"]["rigid-fit"]["bone_error_mm"]["mean"]
    # one patient of the twenty that mismatched_truth judges
    rows += [("experiment 2, S2, rigid-fit [mm] (aim 0.5)", near, "printed", True),
             ("experiment 2, S2, virtual-force over rigid-fit", s2["virtual_force_over_rigid_fit"], ">= 3",
              s2["virtual_force_over_rigid_fit"] >= 3)]
    for r in told["experiment3"]["rows"]:
        cut = r["error_mm"]["cut"]
        rows += [(f"experiment 3, {r['target']}: inside the cut, mean [mm] (paper 0.75, aim 0.5)", cut["mean"], "printed", True),
                 (f"experiment 3, {r['target']}: inside the cut, p90 [mm] (paper 1.5, aim 1.0)", cut["p90"], "printed", True),
                 (f"experiment 3, {r['target']}: peak of the target [mm]", r["peak_mm"], "5 to 8", 5 <= r["peak_mm"] <= 8)]
        if "independent_search" in r:
            ratio = r["independent_search"]["rigid_fit_over_it"]
            rows.append((f"experiment 3, {r['target']}: weighted RMS over an independent search's", ratio, "<= 1.05", ratio <= 1.05))
        if "with_genioplasty" in r:
            named = any("chin" in s and "out of reach" in s for s in r["sentences"])
            before, after = r["chin"]["left_p90_mm"], r["with_genioplasty"]["chin"]["left_p90_mm"]
            rows += [("experiment 3, c: the chin is named as out of reach", int(named), "1", named),
                     ("experiment 3, c: left at the chin, p90 [mm]", before, "printed", True),
                     ("experiment 3, c: the same with a genioplasty [mm]", after, "less", after < before)]
    return rows



def segmented(tier, name, **settings):
    """A case of Testing/Data segmented with settings of its own; its folder and the time it took."""
    case = load(tier.real_case(name))
    case["landmarks"] = str(cases / pathlib.Path(case["landmarks"]).name)
    case["segmentation"] = {**case.get("segmentation", {}), **settings}
    tag = name + "".join(f"-{key}-{value}" for key, value in settings.items())
    file, folder = tier.work / f"{tag}-case.json", tier.work / f"{tag}-segmented"
    file.write_text(json.dumps(case))
    return folder, tier.run("segment", file, "-o", folder)


def read_raw_nrrd(path):
    """Sizes, header and samples (int16) of a NRRD file."""
    content = path.read_bytes()
    end = content.index(b"\n\n") + 2
    header = dict(line.split(": ", 1) for line in content[:end].decode().splitlines() if ": " in line)
    samples = array.array("h")
    packed = content[end:]
    samples.frombytes(gzip.decompress(packed) if header["encoding"].startswith("gz") else packed)
    return [int(n) for n in header["sizes"].split()], header, samples


def doubled(row):
    twice = array.array("h", bytes(4 * len(row)))
    twice[0::2] = twice[1::2] = row
    return twice


def write_big_volume(source, path, size):
    """A CT of int16 at half its voxels' edges, padded with air to a size."""
    (nx, ny, nz), header, samples = read_raw_nrrd(source)
    scaled = re.sub(r"-?[0-9.]+(?:e-?[0-9]+)?", lambda n: repr(float(n[0]) / 2), header["space directions"])
    air = array.array("h", [-1000])
    with path.open("wb") as file:
        file.write(f"NRRD0005\ntype: int16\ndimension: 3\nspace: {header['space']}\nsizes: {size[0]} {size[1]} {size[2]}\n"
                   f"space directions: {scaled}\nkinds: domain domain domain\nendian: little\nencoding: raw\n"
                   f"space origin: {header['space origin']}\n\n".encode())
        for k in range(size[2]):
            plane = array.array("h")
            for j in range(min(size[1], 2 * ny) if k < 2 * nz else 0):
                start = (k // 2 * ny + j // 2) * nx
                row = doubled(samples[start:start + nx])[:size[0]]
                plane.extend(row + air * (size[0] - len(row)))
            plane.extend(air * (size[0] * size[1] - len(plane)))
            plane.tofile(file)


def big_volume(tier):
    """A CT of 512 x 512 x 600 voxels is cropped and resampled within 4 GiB."""
    tier.run("sample", "-o", tier.work / "big-patient", "--spacing", 0.9)
    size = (512, 512, 600)
    ct = tier.work / "big-ct.nrrd"
    write_big_volume(tier.work / "big-patient" / "ct.nrrd", ct, size)
    begin = time.monotonic()
    process = subprocess.Popen([str(tier.program), "-q", "segment", str(ct), "-o", str(tier.work / "big-segmented")])
    _, status, usage = os.wait4(process.pid, 0)
    seconds, gib = time.monotonic() - begin, usage.ru_maxrss / 2 ** 20
    ct.unlink()
    skin = load(tier.work / "big-segmented" / "segment.json")["skin"]
    return [("exit", status, "0", status == 0), ("peak memory [GiB]", gib, "< 4", gib < 4), ("time [s]", seconds, "printed", True),
            ("triangles of the skin", skin["triangles"], "> 10000", skin["triangles"] > 10000),
            ("open edges of the skin", skin["open_edges"], "0", skin["open_edges"] == 0)]


TEMPLATES = ("le-fort-1", "le-fort-2", "le-fort-3", "bsso", "bsso-right", "bsso-left", "genioplasty", "zygoma-right", "zygoma-left")


def every_ct(tier):
    """Every CT of the data through segment, each template's cut, and the mesh of Le Fort I and III; what is no CT is refused."""
    rows = []
    for name in ("cthead_unc", "phantom_imagex"):
        folder, seconds = segmented(tier, name)
        rows.append((f"{name}: segment [s]", seconds, "printed", True))
        case = load(folder / "case.json")
        case.pop("target")
        for template in TEMPLATES:
            case["osteotomies"] = [{"template": template}]
            (folder / "case.json").write_text(json.dumps(case))
            tier.run("cut", folder)
            told = told_by(tier, "check_surfaces", folder)
            faults = sum(part[what] for part in [told["uncut_bone"], *told["fragments"].values()]
                         for what in ("open_edges", "non_manifold_edges", "crossing_triangles"))
            rows += [(f"{name}, {template}: open, non-manifold, crossing", faults, "0", faults == 0),
                     (f"{name}, {template}: fragments + kerf against bone", told["imbalance"], "< 0.001", told["imbalance"] < 0.001)]
            if template in ("le-fort-1", "le-fort-3"):
                tier.run("mesh", folder)
                mesh = load(folder / "mesh.json")
                rows += [(f"{name}, {template}: tetrahedra", mesh["tets"], "printed", True),
                         (f"{name}, {template}: segment and mesh [s]", seconds + mesh["seconds"], "printed", True),
                         (f"{name}, {template}: smallest dihedral angle [deg]", mesh["min_dihedral_deg"], ">= 8", mesh["min_dihedral_deg"] >= 8),
                         (f"{name}, {template}: inverted elements", mesh["inverted_elements"], "0", mesh["inverted_elements"] == 0)]
            tier.run("screenshot", folder, "--show", "fragments-before", "--view", "three-quarter-right", "-o",
                     tier.work / f"{name}-{template}.png")
    labels = tier.data / "seg_dental" / "PostDentalSurgery_Segmentation.nii.gz"
    refused = subprocess.run([str(tier.program), "segment", str(labels), "-o", str(tier.work / "no-ct")], capture_output=True, text=True)
    sentences = len(refused.stderr.strip().splitlines())
    print("seg_dental:", refused.stderr.strip(), flush=True)
    return rows + [("seg_dental, labels and no CT: exit", refused.returncode, "2", refused.returncode == 2),
                   ("seg_dental: lines of its error", sentences, "1", sentences == 1)]


def cut_rows(told, wanted_share):
    met = told["met_bone"]
    for refusal in told["refusals"]:
        print("refused:", refusal, flush=True)
    share = told["closed_and_balanced"] / met
    return [("triangles", told["triangles"], "printed", True),
            ("cuts that meet bone", met, "> 0", met > 0),
            ("of these closed, volumes balanced", share, f">= {wanted_share}", share >= wanted_share),
            ("planes refused", told["plane_refusals"], "0", told["plane_refusals"] == 0),
            ("that made more pieces", told["made_more_pieces"], "> 0", told["made_more_pieces"] > 0),
            ("largest imbalance of volume", told["worst_imbalance"], "< 0.001", told["worst_imbalance"] < 0.001),
            ("mean time of a cut [s]", told["mean_s"], "printed", True)]


def random_cuts(tier):
    """Seeded random planes and curves, kerf 0 to 1 mm, every second pair ending inside bone, through a real skull."""
    folder, _ = segmented(tier, "cthead_unc", spacing_mm=2 if tier.density else 1)
    told = told_by(tier, "random_cuts", folder / "bone.vtp", 20 if tier.density else 500)
    return cut_rows(told, 0.97) + [("longest cut [s]", told["longest_s"], "printed", True)]


def big_cut(tier):
    """The same skull with a million triangles."""
    folder, seconds = segmented(tier, "cthead_unc", spacing_mm=0.69)
    told = told_by(tier, "random_cuts", folder / "bone.vtp", 8, 7)
    million = told["triangles"] >= 1e6
    return [("a million triangles", int(million), "1", million), ("segmenting it [s]", seconds, "printed", True)] + \
        cut_rows(told, 0.97) + [("longest cut [s]", told["longest_s"], "< 5", told["longest_s"] < 5)]


def surfaces(tier):
    """Surfaces of both real CTs: closed, free of crossings (CGAL), and where the CT has them."""
    rows = []
    for name in ("cthead_unc", "phantom_imagex"):
        folder, _ = segmented(tier, name)
        tier.run("cut", folder)
        told = told_by(tier, "check_surfaces", folder)
        parts = {"skin": told["skin"], "bone": told["bone"], "uncut bone": told["uncut_bone"], **told["fragments"]}
        for part, facts in parts.items():
            rows += [(f"{name}, {part}: {what.replace('_', ' ')}", facts[what], "0", facts[what] == 0)
                     for what in ("open_edges", "non_manifold_edges", "crossing_triangles")]
            rows.append((f"{name}, {part}: faces outwards", facts["volume_mm3"], "> 0", facts["volume_mm3"] > 0))
        for part in ("skin", "bone"):
            apart = told[part]["to_ct"]
            rows += [(f"{name}, {part}: mean distance to the CT's isosurface [mm]", apart["mean_mm"], "< 0.2", apart["mean_mm"] < 0.2),
                     (f"{name}, {part}: 95 % [mm]", apart["p95_mm"], "< 0.5", apart["p95_mm"] < 0.5),
                     (f"{name}, {part}: left out, segmentation differs from the threshold", apart["left_out_share"], "printed", True)]
        rows.append((f"{name}: fragments + kerf against bone", told["imbalance"], "< 0.001", told["imbalance"] < 0.001))
    return rows


def level_set(tier):
    """A real CT made worse by blur and noise: bone by the level set against bone by the threshold."""
    ct = tier.data / "cthead_unc" / "ct.nrrd"
    if not ct.exists():
        raise Missing(f"no {ct}: set FACETOBONE_DATA")
    told = told_by(tier, "level_set", ct, 0.7, 150)
    best = max(told["dice_threshold"], told["dice_automatic_threshold"])
    return [("Dice, threshold of the clean CT", told["dice_threshold"], "printed", True),
            ("Dice, automatic threshold", told["dice_automatic_threshold"], "printed", True),
            ("Dice, level set", told["dice_level_set"], "> thresholds", told["dice_level_set"] > best)]


# Where a reader's first inputs lie.
FUZZ_SEEDS = {"case_file": cases, "markups": cases, "materials": here.parents[1] / "Resources" / "materials", "mesh": None,
              "surface": here.parent / "Fuzz" / "seeds" / "surface", "stress_strain": here.parent / "Fuzz" / "seeds" / "stress_strain"}


def fuzz(tier):
    """Readers of ours against libFuzzer under ASan and UBSan, two at a time, FACETOBONE_FUZZ_SECONDS each (600)."""
    if not shutil.which("clang++"):
        raise Missing("no clang++ for the preset fuzz")
    source, build = here.parent.parent, tier.work / "fuzz-build"
    seconds = os.environ.get("FACETOBONE_FUZZ_SECONDS", "600")
    for command in (["cmake", "--preset", "fuzz", "-B", build], ["cmake", "--build", build, "--target", "fuzz_programs"]):
        done = subprocess.run(command, cwd=source, capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(done.stdout[-400:] + done.stderr[-400:])

    def fuzzed(reader):
        corpus = tier.work / f"fuzz_{reader}-corpus"
        corpus.mkdir(exist_ok=True)
        folder = FUZZ_SEEDS[reader]
        for seed in sorted(folder.iterdir()) if folder else ():
            shutil.copy(seed, corpus)
        done = subprocess.run([build / "Testing" / "Fuzz" / f"fuzz_{reader}", corpus, f"-max_total_time={seconds}", "-max_len=16384",
                               "-detect_leaks=0", "-print_final_stats=1", f"-artifact_prefix={tier.work / f'fuzz_{reader}-'}"],
                              capture_output=True, text=True, errors="replace")
        runs = re.search(r"number_of_executed_units: (\d+)", done.stderr)
        return [(f"{reader}: exit", done.returncode, "0", done.returncode == 0),
                (f"{reader}: seconds", int(seconds), ">= 600", int(seconds) >= 600),
                (f"{reader}: inputs tried", int(runs[1]) if runs else 0, "> 1000", bool(runs) and int(runs[1]) > 1000)]

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return [row for rows in pool.map(fuzzed, FUZZ_SEEDS) for row in rows]


def mesh_growth(tier):
    """Time of the volume mesh against its number of tetrahedra, 30 thousand to a million."""
    folder, _ = segmented(tier, "cthead_unc")
    tier.run("cut", folder)
    case = load(folder / "case.json")
    rows, points = [], []
    for density in (0.15, 1, 3, 12):
        case["mesh"] = {**case.get("mesh", {}), "density": density}
        (folder / "case.json").write_text(json.dumps(case))
        tier.run("mesh", folder)
        told = load(folder / "mesh.json")
        points.append((told["tets"], told["seconds"]))
        histogram = told["dihedral_histogram"]
        rows += [(f"{told['tets']} tetrahedra: time [s]", told["seconds"], "printed", True),
                 (f"{told['tets']} tetrahedra: share below 10 degrees", histogram["share_below_10_deg"], "printed", True),
                 (f"{told['tets']} tetrahedra: smallest dihedral angle [deg]", told["min_dihedral_deg"], ">= 8", told["min_dihedral_deg"] >= 8),
                 (f"{told['tets']} tetrahedra: inverted", told["inverted_elements"], "0", told["inverted_elements"] == 0)]
    (n, t), (m, u) = points[0], points[-1]
    exponent = math.log(u / t) / math.log(m / n)
    return rows + [("time grows with this power of the number", exponent, "<= 1.2", exponent <= 1.2)]


def window_pictures(tier):
    """The window driven through every step of two cases, pictured at 1920 x 1080 and 1366 x 768."""
    tier.run("sample", "-o", tier.work / "window-patient")
    rows = []
    for name, case in (("sample", tier.work / "window-patient" / "case.json"), ("cthead_unc", tier.real_case("cthead_unc"))):
        settings = load(case)
        settings["mesh"] = {"density": 0.3}
        if "landmarks" in settings:
            settings["landmarks"] = str(case.parent / settings["landmarks"])
        if name == "sample":
            settings["ct"] = str(case.parent / settings["ct"])
            settings["target"]["warp"] = {**settings["target"]["warp"], **{
                end: str(case.parent / settings["target"]["warp"][end]) for end in ("from", "to")}}
        copy = tier.work / f"window-{name}.json"
        copy.write_text(json.dumps(settings))
        os.environ["FACETOBONE_PROGRAM"] = str(tier.program)
        told = told_by(tier, "window_pictures", copy, tier.work / f"window-{name}")
        for fault in told["clipped"] + told["unnamed"]:
            print(f"{name}: {fault}", flush=True)
        rows += [(f"{name}: pictures, to be looked at", told["pictures"], ">= 30", told["pictures"] >= 30),
                 (f"{name}: clipped words", len(told["clipped"]), "0", not told["clipped"]),
                 (f"{name}: controls without a name", len(told["unnamed"]), "0", not told["unnamed"]),
                 (f"{name}: CT alone, seen after [s]", told["bare_ct"]["seconds_to_first_image"], "printed", True)]
    return rows


def window_tutorial(tier):
    """What tutorial.md says, done by the words on the window's buttons."""
    os.environ["FACETOBONE_PROGRAM"] = str(tier.program)
    told = told_by(tier, "window_tutorial", tier.work / "window-tutorial")
    for fault in told["clipped"] + told["unnamed"]:
        print(f"tutorial: {fault}", flush=True)
    return [("pictures, to be looked at", told["pictures"], ">= 28", told["pictures"] >= 28),
            ("clipped words", len(told["clipped"]), "0", not told["clipped"]),
            ("controls without a name", len(told["unnamed"]), "0", not told["unnamed"])]


def window_speed(tier):
    """A dab of each brush on 100 000 vertices, the live plan, and the time to the first image."""
    told = json.loads(subprocess.run([tier.tool("Benchmarks/benchmark_sculpting"), "--benchmark_format=json",
                                      "--benchmark_filter=/316/"], capture_output=True, text=True, check=True).stdout)
    rows = [(f"{b['name']} of {b.get('vertices', 316 ** 2):.0f} vertices, processor [ms]", b["cpu_time"], "<= 16", b["cpu_time"] <= 16)
            for b in told["benchmarks"]]
    patient, folder = tier.work / "speed-patient", tier.work / "speed-case"
    if not folder.exists():
        tier.run("sample", "-o", patient)
        tier.run("run", patient / "case.json", "-o", folder)
    for name, case in (("CT", patient / "ct.nrrd"), ("planned", folder)):
        begin = time.monotonic()
        window = subprocess.Popen(["xvfb-run", "-a", tier.program.parent / "FaceToBone", "--time-first-image", case],
                                  stdout=subprocess.PIPE, text=True,
                                  env=dict(os.environ, XDG_CONFIG_HOME=str(tier.work / "settings")))
        line = window.stdout.readline()
        seconds = time.monotonic() - begin
        window.communicate()
        print(f"sample patient, {name}: {line.strip()}", flush=True)
        own = re.search(r"after ([\d.]+) s", line)
        rows.append((f"sample patient, {name}: first image, with the display's own start [s]", seconds, "printed", bool(own)))
        if own:
            rows.append((f"sample patient, {name}: first image after [s]", float(own[1]), "<= 3", float(own[1]) <= 3))
    for name, case in (("sample patient", folder), ("cthead_unc", tier.planned("cthead_unc")[0])):
        told = told_by(tier, "window_moves", case)
        print(f"{name}: {json.dumps(told)}", flush=True)
        rows += [(f"{name}: mouse move to moved fragments, processor [ms]", told["mean_ms"], "<= 50", told["mean_ms"] <= 50),
                 (f"{name}: the same, largest", told["largest_ms"], "printed", True),
                 (f"{name}: moves of {told['moves']} that the fragments followed", told["moves_that_fragments_followed"],
                  "> 3/4", told["moves_that_fragments_followed"] > 0.75 * told["moves"])]
    return rows


CHECKS = {
    "cthead_unc": lambda tier: real_ct(tier, "cthead_unc"),
    "phantom_imagex": lambda tier: real_ct(tier, "phantom_imagex"),
    "movements": movements,
    "reproducible": reproducible,
    "forward_solve": forward_solve,
    "random_movements": random_movements,
    "recovery": recovery,
    "mismatched_truth": mismatched_truth,
    "experiments_sample": lambda tier: experiments(tier, "sample"),
    "experiments_cthead": lambda tier: experiments(tier, "cthead_unc"),
    "postoperative": postoperative,
    "plan_time": plan_time,
    "mtm_lfem": mtm_lfem,
    "calculix": calculix,
    "every_ct": every_ct,
    "big_volume": big_volume,
    "random_cuts": random_cuts,
    "big_cut": big_cut,
    "surfaces": surfaces,
    "mesh_growth": mesh_growth,
    "level_set": level_set,
    "fuzz": fuzz,
    "benchmarks": benchmarks,
    "scenes": scenes,
    "window_pictures": window_pictures,
    "window_tutorial": window_tutorial,
    "window_speed": window_speed,
    "sanitizers": sanitizers,
    "window_events": window_events,
}


def checked(tier, name, stamp):
    """Rows of a check, from the last run of the same program where there is one."""
    kept = tier.work / f"{name}.result.json"
    if kept.exists() and load(kept)["stamp"] == stamp:
        return load(kept)["rows"]
    print(f"running {name} ...", flush=True)
    try:
        rows = CHECKS[name](tier)
    except Missing as reason:
        return [(f"skipped: {reason}", float("nan"), "done", False)]
    except Exception as failure:  # one failed check must not hide the others
        return [(f"failed: {failure}", float("nan"), "done", False)]
    kept.write_text(json.dumps({"stamp": stamp, "rows": rows}))
    return rows


def print_table(table):
    width = max(len(row[0]) for row in table)
    print(f"\n{'name':{width}}  {'value':>12}  {'required':>10}  result")
    for row in table:
        print(f"{row[0]:{width}}  {row[1]:>12}  {row[2]:>10}  {row[3]}")


def text_row(name, what, value, required, passed):
    return f"{name}: {what}", f"{value:.6g}", required, "pass" if passed else "FAIL"


def quick(tier, name):
    try:
        rows = CHECKS[name](tier)
    except Missing as reason:
        print(f"skipped: {reason}")
        return 77
    print_table([text_row(name, *row) for row in rows])
    return 0 if all(row[3] for row in rows) else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=pathlib.Path, required=True)
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--only", choices=CHECKS)
    parser.add_argument("--quick", choices=CHECKS)
    options = parser.parse_args()
    if options.quick:
        sys.exit(quick(Tier(options.program, options.data, options.work, 0.3), options.quick))
    tier = Tier(options.program, options.data, options.work)
    digest = hashlib.sha256(tier.program.read_bytes())
    for path in sorted(cases.glob("*.json")):
        digest.update(path.read_bytes())
    digest.update(pathlib.Path(__file__).read_bytes())
    failed = 0
    table = []
    for name in [options.only] if options.only else CHECKS:
        for what, value, required, passed in checked(tier, name, digest.hexdigest()):
            table.append(text_row(name, what, value, required, passed))
            failed += not passed
    print_table(table)
    print(f"\n{len(table) - failed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
