page-settings = Settings

# The sections
settings-page-find = Find a setting
settings-page-sections = Section
settings-page-general = General
settings-page-appearance = Appearance
settings-page-rule = Rule and limits
settings-page-own-files = Own files
settings-page-records = Records
settings-page-shop-server = Shop server
settings-page-folders = Folders
settings-page-keys = Keys
settings-page-about = About
settings-page-nothing = No setting has these words
settings-page-defaults = Back to defaults
settings-page-defaults-hint = Sets this section as at the first start. Files, names and addresses stay.

# General
settings-page-language-about = All texts of the window, and its decimal sign.
settings-page-own-texts = Own texts
settings-page-own-texts-about = Words of your shop in place of the built-in ones: a Fluent file for one language, such as nl_OurShop.ftl.
settings-page-own-texts-count = { $file }: { $count } of { $all } texts are yours
settings-page-own-texts-reading = { $file } is being read
settings-page-own-texts-unread = { $file } could not be read and is not in use: { $why }
settings-page-own-texts-elsewhere = They are texts in { $language } and count only while the window speaks that language.
settings-page-own-texts-refused = { $count ->
    [one] 1 text is refused, and the built-in one is said:
   *[other] { $count } texts are refused, and the built-in ones are said:
}
settings-page-own-texts-more = … and { $count } more
load-texts = Own texts…
no-own-texts = Stop using own texts
dialog-own-texts = Own texts
file-kind-own-texts = Texts
settings-page-keypad-about = Large keys for touch screens and gloves.
sounds = Sounds
sounds-about = Each verdict is heard: one long tone is good, two tones ask for a look at the part, three are scrap. Simulated values are not heard.
sounds-failed = No sound is heard: { $reason }
sounds-no-player = No sound is heard: none of these programs is on this computer: { $players }
settings-page-shop = Settings for the whole shop
settings-page-shop-about = One file for other stations. It has no name, no address of a server and no callout.
settings-page-export = Export settings…
settings-page-import = Import settings…
settings-page-dialog-export = Export settings
settings-page-dialog-import = Import settings
settings-page-imported = { $count ->
    [0] { $name }: nothing is different
    [one] { $name }: 1 setting changed
   *[other] { $name }: { $count } settings changed
}
settings-page-unknown-key = { $key } is not a setting of this version. An export keeps it.
settings-page-no-version = the file has no version: it is not a file of settings
settings-page-edition = Edition of ISO 286
file-kind-settings = Settings

# Appearance
settings-page-colours = Colours
settings-page-colours-about = The verdict also has a word and a shape, whatever its colour.
settings-page-zoom = Zoom
settings-page-zoom-about = Scales everything. The keys are Ctrl with plus, minus and 0.
settings-page-zoom-out = Zoom out
settings-page-zoom-in = Zoom in
settings-page-zoom-normal = Zoom to 100 %
settings-page-percent = { $percent } %
settings-page-density-about = Automatic: a touch makes buttons and fields larger, the mouse makes them smaller.
settings-page-decimal = Decimal sign
settings-page-decimal-about = In the window. Reports follow their language, files their own settings.
settings-page-decimal-of-language = From the language
settings-page-decimal-point = 25.012
settings-page-decimal-comma = 25,012
settings-page-rows = Rows of lists
settings-page-rows-about = Height of the rows of tables: usual is 32 px, close is 26 px. By touch always 48 px.
settings-page-rows-usual = Usual
settings-page-rows-close = Close

# Rule and limits
settings-page-limits-about = Where the limits of a class are looked up. Your own tables always come first.
settings-page-js-about = For drawings by the edition of 1988, grades 7 to 11. Otherwise half micrometres are kept.
settings-page-1988-about = For drawings by the edition of 1988. Otherwise they are defined for larger sizes, too.
settings-page-decision-rule = Decision rule
settings-page-decision-rule-about = Which part of the zone is accepted, given the uncertainty of the value.
settings-page-prover = Burden of proof
settings-page-prover-about = Who has to prove that a part conforms, or does not.
settings-page-uncertainty-from = Uncertainty is given as
settings-page-uncertainty-from-about = A typed value, or the budget, which knows each size and its contacts.
settings-page-uncertainty-about = Of every value on the check page. Empty: not known.
settings-page-coverage-about = How many standard uncertainties make the expanded one.
settings-page-budget = Uncertainty budget
settings-page-budget-about = Open a budget on its page and use it for checks.
settings-page-guard-factor-about = The width of the guard band, for rules that take a multiple.
settings-page-guard-width-about = For the rule with a fixed guard band.
settings-page-part-temperature = Temperature of the part
settings-page-part-temperature-about = Values are corrected to 20 °C. Empty: not corrected.
settings-page-part-expansion-about = How much the material of the part expands.
settings-page-scale-temperature = Temperature of the scales
settings-page-scale-temperature-about = Only if the machine does not compensate for it.
settings-page-scale-expansion-about = How much the scales of the machine expand.
settings-page-clearance-about = How far from the surface the probe begins to look for it.
settings-page-height = Measuring height Z
settings-page-height-about = At which height the probe touches the workpiece.
settings-page-first-contact-about = The angle of the first contact.
settings-page-centre-tolerance-about = How far the centre may be off in X and Y. 0: not monitored.

# Own files
settings-page-own-tables = Own tables
settings-page-own-tables-about = A folder with tables as on your control. They come before ISO 286.
settings-page-mask = Mask of the status window
settings-page-mask-about = What the control prints, in which language.
settings-page-own-mask = Own mask
settings-page-own-mask-about = A mask file of your control in place of the built-in one.
settings-page-columns = Columns of files
settings-page-columns-about = Shows which column is which before a file is imported, and remembers it.

# Records
settings-page-journal = Journal
settings-page-journal-about = Every check is written here. The state file can name another file.
settings-page-who-about = Each check is recorded with this name.
settings-page-station = Station
settings-page-station-about = The name of this computer in the records.

# Shop server
settings-page-server = Address of the server
settings-page-server-about = Sends each record to PostgreSQL in the background, such as postgres://mill3@shop.example/checks. A password goes to the keyring.
settings-page-sent = Sent so far
settings-page-sent-about = Records wait on this computer until the server has them.

# Folders
settings-page-watched = Watched folder
settings-page-watched-about = Files dropped into it are judged by the open plan and recorded.
settings-page-recent-about = The menu lists the files that were read last.
settings-page-recent-count = { $count ->
    [0] no files
    [one] 1 file
   *[other] { $count } files
}

# Keys
settings-page-everywhere = Everywhere
settings-page-on-workpiece = Cycles and programs
settings-page-in-dialog = In the file dialog

# About
settings-page-version = Version
settings-page-version-about = Fitcheck tells at a glance whether a measured hole or shaft is good.
settings-page-version-is = { $version }, commit { $commit }
settings-page-unknown = unknown
settings-page-licences = Licences of what is built in
settings-page-licence = Licence
settings-page-licence-about = Free software. The embedded fonts have licences of their own.
settings-page-state-file = State file
settings-page-state-file-about = Keeps settings, fields and recent files, a second after each change.
settings-page-journal-file = Journal file
settings-page-journal-file-about = Keeps every check of this station.
settings-page-not-used = not in use
settings-page-own-tables-unread = { $folder } could not be read and is not in use
settings-page-nowhere = not kept
settings-page-changed = { $name } was changed
settings-page-several-changed = { $count } settings were changed
settings-page-take-back = Undo the last change of a setting
settings-page-preview = Example with these settings

## The size of the screen
ruler = Size of the screen
ruler-about = Hold a bank card to the picture and make it as wide: an operator’s buttons are 20 mm then
ruler-card = A bank card: not compared yet
ruler-known = A bank card, 85.6 mm
ruler-much-shorter = Much shorter
ruler-shorter = A little shorter
ruler-longer = A little longer
ruler-much-longer = Much longer
ruler-forget = Forget
settings-page-company = Company on reports
settings-page-company-about = Stands at the top of PDF and HTML, unless the template names a company.
settings-page-company-address = Address on reports
settings-page-company-address-about = A semicolon begins a new line.
settings-page-company-logo = Logo on reports
settings-page-company-logo-about = The whole path of a PNG, JPEG or SVG file.
settings-page-company-logo-place = { $given } is not a whole path: begin with the drive or the root folder
