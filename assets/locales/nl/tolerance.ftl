# tolerance
