page-parts = Parts
parts-page-walk = Measure
parts-page-plan = Plan
parts-page-new = New plan
parts-page-open = Open plan…
parts-page-save = Save plan…
parts-page-save-csv = Save plan as CSV…
parts-page-undo = Undo
parts-page-redo = Redo
parts-page-dialog-open = Open a part plan
parts-page-dialog-save = Save the part plan
parts-page-not-saved = { $name }, not saved
parts-page-no-plan = No plan yet: open or create one.
parts-page-move = Go to another cell
parts-page-extend = Extend the selection
parts-page-edit = Edit cell
parts-page-take = Done
parts-page-empty = Clear cells
parts-page-copy = Copy cells
parts-page-paste = Paste
parts-page-insert = Insert row
parts-page-delete = Delete rows
parts-page-up = Move up
parts-page-down = Move down
parts-page-sort = Sort
parts-page-sort-hint = Sorts by the column of the current cell, A2 before A10; sort again to reverse the order
parts-page-renumber = Renumber
parts-page-renumber-hint = Numbers the features from 1 in row order
parts-page-all-columns = All columns
parts-page-previous = Previous fault
parts-page-next = Next fault
parts-page-choose-picture = Choose picture…
parts-page-dialog-picture = Choose the picture of the part
parts-page-table = Features of the plan
parts-page-cell-name = Cell of the plan
parts-page-cell = Row { $row }, { $column }, { $text }
parts-page-cell-empty = Row { $row }, { $column }, empty
parts-page-cell-wrong = { $cell }, fault: { $what }
parts-page-new-row = new
parts-page-limits = Limits
parts-page-editing = { $column } of row { $row }
parts-page-head = Part
parts-page-words = One of: { $words }
parts-page-no-fault = No faults in the plan
parts-page-blank = Type the first feature, or paste rows from a spreadsheet
parts-page-faults = { $count ->
    [one] One fault
   *[other] { $count } faults
}
parts-page-features = { $count ->
    [one] One feature
   *[other] { $count } features
}
parts-page-fault-of = { $row }, { $column }
parts-page-fault-row = Row { $row }
parts-page-fault-plan = Plan
parts-page-lost = Not understood in the file: the plan measures and saves nothing until this is corrected in the file or left out here
parts-page-take-meant = Use { $meant }
parts-page-leave-out = Leave these out
parts-page-leave-out-hint = The plan then has only what could be read; what was not understood may be a feature
parts-page-left-out = { $count ->
    [one] { $name }: one entry that was not understood is left out of the plan; the file keeps it until the plan is saved
   *[other] { $name }: { $count } entries that were not understood are left out of the plan; the file keeps them until the plan is saved
}
parts-page-pasted-rows = { $count ->
    [one] One pasted row was skipped: a plan has at most { $most } features
   *[other] { $count } pasted rows were skipped: a plan has at most { $most } features
}
parts-page-pasted-columns = { $count ->
    [one] One pasted column was skipped: there are no more columns to its right. “All columns” shows more
   *[other] { $count } pasted columns were skipped: there are no more columns to the right. “All columns” shows more
}
parts-page-column-number = No.
parts-page-column-name = Name
parts-page-column-kind = Kind
parts-page-column-axis = Axis
parts-page-column-callout = Callout
parts-page-column-callout2 = Callout Y
parts-page-column-feature = Hole or shaft
parts-page-column-x = X
parts-page-column-y = Y
parts-page-column-z = Z
parts-page-column-angle = Angle
parts-page-column-clearance = Clearance
parts-page-column-clearance-height = Clearance height
parts-page-column-cycle = Cycle
parts-page-column-parameters = Parameters
parts-page-column-material = Material
parts-page-column-rule = Rule
parts-page-column-u-um = u (µm)
parts-page-column-plausible = Plausible
parts-page-column-plausible2 = Plausible Y
parts-page-column-remark = Remark
parts-page-column-balloon-x = Balloon X
parts-page-column-balloon-y = Balloon Y
parts-page-head-part = Part
parts-page-head-drawing = Drawing
parts-page-head-picture = Picture
parts-page-head-material = Material
parts-page-head-rule = Rule
parts-page-head-u-um = u (µm)
parts-page-head-travel-x = Travel X (mm)
parts-page-head-travel-y = Travel Y (mm)
parts-page-head-travel-z = Travel Z (mm)
parts-page-head-remark = Remark
parts-page-head-file = file beside the plan
parts-page-head-two = min max
parts-page-picture = Picture of the part
parts-page-picture-said = Picture of the part, { $on } of { $count } balloons placed
parts-page-picture-none = No picture
parts-page-picture-awaited = Reading the picture
parts-page-picture-folder = { $given } is not the name of a file beside the plan: the picture must be in the plan's folder, so give its name without a folder
parts-page-picture-unsaved = Save the plan first: the picture must be in the same folder
parts-page-picture-elsewhere = { $given } is not in the plan's folder: copy it there first, so that both stay together
parts-page-picture-large = { $name } has { $given } KiB; a picture has at most { $most } KiB
parts-page-picture-dots = { $name } has { $width } × { $height } pixels; a picture has at most { $most } million pixels
parts-page-picture-kind = { $name } is not a PNG, JPEG or SVG picture
parts-page-picture-broken = { $name } cannot be read as a picture: { $reason }
parts-page-balloon = Balloon { $label }, { $name }, { $status }
parts-page-balloon-next = { $balloon }, next
parts-page-balloon-beside = { $balloon }, not on the picture
parts-page-balloon-open = not measured
parts-page-balloon-skipped = skipped
parts-page-beside = Not on the picture yet: drag them onto it
parts-page-beside-more = and { $count } more
parts-page-balloon-simulated = { $status }, simulated
parts-page-more = Rows and cells
parts-page-picture-heavy = { $name } would take too long to draw: it has filters, large patterns or too many layers; remove them, or save the picture as PNG
parts-page-csv-copy = The file is a copy: CSV has only the features, and { $keys } of the part is left out
parts-page-opened = { $count ->
    [one] { $name } is open, but the plan leaves out one thing that the file has
   *[other] { $name } is open, but the plan leaves out { $count } things that the file has
}
parts-page-pasted-twice = A pasted column was left out: the first row names { $keys } more than once, and the first column of that name is used
parts-page-pasted-unknown = Pasted columns that a plan does not have were left out: { $names }
parts-page-pasted-nameless = { $count ->
    [one] One pasted column was left out: the first row has no name above it
   *[other] { $count } pasted columns were left out: the first row has no names above them
}
parts-page-comments = { $count ->
    [one] Saving removes a comment from the file
   *[other] Saving removes { $count } comments from the file
}
parts-page-comments-lost = { $count ->
    [one] A comment was removed from { $name }: a plan is written without comments
   *[other] { $count } comments were removed from { $name }: a plan is written without comments
}
