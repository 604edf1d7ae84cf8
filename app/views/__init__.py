"""The four views on the screen: widgets that show pictures and take what the mouse does."""
