"""Fails where a room includes what it must not know; arrows point down only."""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parents[2]
ROOMS = {
    "Core": {"Core"},
    "Imaging": {"Core", "Imaging"},
    "Meshing": {"Core", "Meshing"},
    "Bridge": {"Core", "Bridge"},
    "Rendering": {"Core", "Rendering"},
    "Case": {"Core", "Imaging", "Meshing", "Bridge", "Rendering", "Case"},
    "Scene": {"Core", "Bridge", "Case", "Scene"},
    "CommandLine": {"Core", "Bridge", "Rendering", "Case", "Scene", "CommandLine"},
    "Widgets": {"Core", "Bridge", "Case"},
    "Widgets/VTK": {"Core"},
    "Widgets/MRML": {"Core", "Bridge"},
    "Widgets/Desktop": {"Core", "Rendering"},
}
LIBRARIES = {  # first letters of a header -> the rooms that may include it
    r"vtk(?!MRML|Slicer)": {"Meshing", "Bridge", "Rendering", "Case", "Scene", "CommandLine", "Widgets", "Widgets/VTK",
                            "Widgets/MRML", "Widgets/Desktop"},
    r"itk": {"Imaging", "Bridge"},
    r"CGAL/": {"Meshing"},
    r"nlohmann/": {"Bridge", "Case", "Scene", "CommandLine", "Widgets"},
    r"valijson/": {"Case"},
    r"openssl/": {"Case"},
    r"CLI/": {"CommandLine"},
    r"Q[A-Z]": {"Widgets", "Widgets/Desktop"},
    r"qMRML|qSlicer": set(),
    r"vtkMRML": {"Scene", "CommandLine", "Widgets", "Widgets/MRML"},
    r"vtkSlicer": {"CommandLine", "Widgets"},
    r"cholmod": {"Core"},
    r"(fstream|filesystem)$": set(ROOMS) - {"Core"},
}


def faults(path, room):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        include = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', line)
        if not include:
            continue
        header = include.group(1)
        other = header.split("/")[0]
        if other in ROOMS and other not in ROOMS[room]:
            yield f"{path.relative_to(root)}:{number}: {room} must not include {other}"
        for pattern, allowed in LIBRARIES.items():
            if re.match(pattern, header) and room not in allowed:
                yield f"{path.relative_to(root)}:{number}: {room} must not include {header}"


def sources(room):
    """Rooms of Logic with their folders; those of Widgets without, as these are rooms themselves."""
    within = root.glob(room + "/*") if room.startswith("Widgets") else (root / "Logic" / room).rglob("*")
    return sorted(path for path in within if path.suffix in {".hpp", ".cpp", ".h", ".cxx"})


found = [fault for room in ROOMS for path in sources(room) for fault in faults(path, room)]


def mrml_faults(path):
    """What shares its sources with Slicer: no Slicer header besides those that the stand-in has, in MRML no room above it."""
    in_mrml = path.is_relative_to(root / "MRML")
    for number, line in enumerate(path.read_text().splitlines(), 1):
        include = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', line)
        header = include.group(1) if include else ""
        slicer = re.match(r"vtkMRML|vtkSlicer|vtkArchive|vtkObserverManager|qMRML|qSlicer|ctk", header)
        known = stand_in | MODULE_HEADERS if "Module" in path.parts else stand_in
        if slicer and "FaceToBone" not in header and header not in known:
            yield f"{path.relative_to(root)}:{number}: MRML/StandIn has no {header}"
        if in_mrml and (header.split("/")[0] in ROOMS or re.match(r"Q[A-Z]|CGAL/", header)):
            yield f"{path.relative_to(root)}:{number}: MRML must not include {header}"


# Slicer's own, for the module's class, panel and hold on the views alone
MODULE_HEADERS = {"ctkVTKObject.h", "qMRMLThreeDView.h", "qMRMLThreeDWidget.h", "qSlicerAbstractModuleWidget.h",
                  "qSlicerApplication.h", "qSlicerLayoutManager.h", "qSlicerLoadableModule.h"}
stand_in = {path.name for path in (root / "MRML" / "StandIn").rglob("*.h")}
found += [fault for folder in ("MRML", "Logic", "Widgets") for path in sorted((root / folder).rglob("*.*"))
          if path.suffix in {".h", ".cxx", ".hpp", ".cpp"} for fault in mrml_faults(path)]
holds = {entry.name for entry in root.iterdir() if not entry.name.startswith(".")}
extra = holds - {"CMakeLists.txt", "CMakePresets.json", "README.md", "LICENSE", "Logic", "MRML", "Widgets",
                 "Testing", "Resources"}
found += [f"the top level holds {name}" for name in sorted(extra)]
print("\n".join(found) or "every room includes only what it may")
sys.exit(1 if found else 0)
