page-help = Help

help-page-help = Help for this page
help-page-help-hint = Opens the manual; on the help page, returns to the page before it
help-page-explain = Explain this field
help-page-explain-hint = Shows what the field is for, its unit, its range and an example
help-page-about-field = Help for { $name }
help-page-in-manual = In the manual
help-page-entry = Help: { $title }
help-page-keys = Keyboard shortcuts
help-page-search = Search the manual
help-page-open-found = Open the best match
help-page-nothing = No page of the manual has these words.
help-page-topics = Contents
help-page-list = Pages of the manual
help-page-found = { $title }, { $heading }
help-page-found-line = { $place }: { $line }
help-page-move = Go to another page of the manual
help-page-read = Show the page
help-page-scroll = Scroll the text
help-page-back = Back
help-page-english = The manual is in English.

# Samples
help-page-samples = Try it
help-page-sample-value = Try 25 H7 with 25.012
help-page-sample-part = Open a sample part
help-page-sample-file = Open a sample file
help-page-sample-program = Open a sample program
help-page-sample-hint = Samples are part of the program. The values in the sample file are marked as simulated.

# The sheet of keys
help-page-keys-about = A key of a page works while that page is open.
help-page-everywhere = On every page
help-page-in-dialogs = In dialogs
help-page-on-workpiece = Simulated workpiece
help-page-key-row = { $keys }: { $text }
