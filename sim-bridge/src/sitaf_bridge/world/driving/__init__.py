"""Running simulations: time, parameters, saved states, conditions and recordings of motion."""
