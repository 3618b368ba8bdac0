page-pairing = Paren
