"""Pictures of the views: the only importer of VTK."""
