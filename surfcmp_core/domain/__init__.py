"""Where there is something to compare: footprints of surfaces, and which triangles count."""

from surfcmp_core.domain.compared import Reason, reasons
from surfcmp_core.domain.footprint import Footprint, footprint_of_cloud, footprint_of_mesh
from surfcmp_core.domain.own_faces import OwnFaces, own_faces

__all__ = [
    "Footprint",
    "OwnFaces",
    "Reason",
    "footprint_of_cloud",
    "footprint_of_mesh",
    "own_faces",
    "reasons",
]
