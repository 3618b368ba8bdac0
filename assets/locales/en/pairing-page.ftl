page-pairing = Pairing
