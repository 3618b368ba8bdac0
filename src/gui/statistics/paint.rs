//! From a picture to the screen.
