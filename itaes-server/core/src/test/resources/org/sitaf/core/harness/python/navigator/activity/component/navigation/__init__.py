"""A component that asks a range finder and drives wheels."""
