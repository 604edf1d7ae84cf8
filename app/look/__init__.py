"""How the window looks: colours, icons, numerals, words."""
