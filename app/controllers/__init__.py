"""What ties the model to the views and the jobs."""
