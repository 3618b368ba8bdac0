//! Files of other tools: one file a format, bytes in and bytes out.
