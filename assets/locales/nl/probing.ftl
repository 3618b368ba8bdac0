# probing
