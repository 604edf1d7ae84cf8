"""Square cells over the plane, into which triangles are sorted."""
