"""What a file looks like, whatever its name ends in."""

import re

_STARTS: dict[bytes, str] = {
    rb"ply[\r\n]": "a .ply file",
    rb"(?i)solid\b[^\n]*\n\s*facet\b": "a text .stl file",
    rb"(ST|[CNn4])*OFF\b": "an .off file",
    rb"# vtk DataFile": "a .vtk file",
    rb"(<\?xml[^>]*>\s*)?(<!--[^>]*>\s*)*<VTKFile": "a .vtp file or another of VTK's in XML",
    rb"\x93NUMPY": "a .npy file",
    rb"PK\x03\x04": "a ZIP archive, such as .npz or .xlsx",
    rb"LASF": "a .las or .laz file",
    rb"\x1f\x8b": "a file packed by gzip",
    rb"\x89PNG|\xff\xd8\xff|GIF8|BM.{4}\0\0|II\*\0|MM\0\*": "a picture",
    rb"%PDF": "a PDF document",
    rb"glTF": "a .glb scene",
    rb"\xd0\xcf\x11\xe0": "an old Office document",
    rb"(?s).{128}DICM": "a DICOM image",
    rb"(?i)(<!doctype html|<html)": "a page of the web",
    rb"(?i)(\n|#.*\n|(mtllib|usemtl|o|g|s)\s.*\n)*v[ \t]+[-+.\d]+[ \t]+[-+.\d]": "an .obj file",
}
_RECORD = 50
_START = 84


def looks_like(data: bytes) -> str | None:
    """Name what the bytes begin like, for a message; None where nothing is sure."""
    start = data[:4096].removeprefix(b"\xef\xbb\xbf").lstrip(b" \t\r\n") or data[:4096]
    for pattern, kind in _STARTS.items():
        if re.match(pattern, start):
            return kind
    declared = int.from_bytes(data[_START - 4 : _START], "little")
    if declared and len(data) == _START + declared * _RECORD:
        return "a binary .stl file"
    return None
