"""What Carom answers, as classes: one module for each command whose JSON it is."""
