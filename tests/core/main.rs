<<<<<<< HEAD
//! The core and the command line.

mod masks;
=======
//! Tests of the core and the command line, in one binary.

mod import;
mod logs;
>>>>>>> exchange
