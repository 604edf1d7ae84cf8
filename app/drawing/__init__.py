"""Pictures of the views: the only importer of pyvista.

pyvista never owns a widget here. One off-screen plotter draws all views as tiles, on a thread of
its own, and the tiles arrive as images. So the window never waits for a picture, nothing depends on
how Qt and OpenGL share a screen, and what is on the screen can be grabbed, printed and tested.
"""
