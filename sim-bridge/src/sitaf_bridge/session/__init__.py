"""Sessions: isolated simulations that live as long as their client keeps the lease."""
