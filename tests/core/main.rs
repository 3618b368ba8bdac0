mod circles;
