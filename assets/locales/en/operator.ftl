# The window for an operator

operator-mode = Who this window is for
operator-mode-about = An operator has measuring, results and help, in large letters; everything else is in the full window
operator-mode-operator = Operator
operator-mode-operator-about = Measure, results and help, for fingers, gloves and two metres.
operator-mode-full = Everything
operator-mode-full-about = All pages, for a desk.
operator-question = Who is this window for?
operator-question-later = It can be changed in the settings at any time; an operator gets there by “Leave”.
operator-leave = Leave
operator-report = Report
operator-undo = Undo
operator-measure = Measure
operator-results = Results
operator-one-size = One size
operator-part = Part
operator-last = Last results
operator-newer = Newer
operator-older = Older
operator-back-to-results = Back to the results
operator-dropped = { $name } is not opened here: an operator opens no files. Leave to the full window first.
operator-no-results = Nothing was measured yet.
operator-features = { $count ->
    [one] 1 feature
   *[other] All { $count } features
}
operator-next = Next
operator-next-part = Next part
operator-to-value = Value
operator-type-callout = Type what the drawing says, such as 25 H7.
operator-type-value = Measure, and type the value.
operator-choose-part = Choose a part, and type its serial number.
operator-hole-or-shaft = Which one is measured?
operator-plans = Parts
operator-no-plans = No plan was opened on this computer yet. Plans are opened in the full window, on the page Parts.
operator-go-on-first = Read the verdict and press Next first: what was typed before that was not taken

## The PIN
operator-pin = PIN of the operator’s window
operator-pin-about = Who leaves the operator’s window types it. Only a salted hash of it is kept
operator-pin-use = Lock with this PIN
operator-pin-remove = Remove the PIN
operator-pin-try = Unlock
operator-stay = Stay
operator-pin-short = a PIN has { $least } signs or more
operator-pin-set = The operator’s window is locked with a PIN from now on
operator-pin-removed = The operator’s window is not locked any more
operator-pin-wrong = This is not the PIN
operator-pin-not-hashed = The PIN could not be hashed: { $why }
operator-pin-asked = Type the PIN to leave the operator’s window.
operator-pin-forgotten = Forgotten? The manual says how an administrator gets in: The operator’s window, The PIN.
