"""What a world says of itself: its files, its world description, and the checks that need no MuJoCo."""
