use super::Reader;
use yformat::diagnostic::Diagnostic;

/// Reports what a deck asks for and this program does not simulate.
pub(super) fn check(reader: &mut Reader<'_>) {
    for (count, what) in [("YDB/NBORH", "boreholes"), ("YDS/NSOUR", "pressure sources")] {
        let n = reader.integer(count);
        if n > 0 {
            reader.report(
                Diagnostic::error(
                    "scene::not-simulated",
                    format!("{count} asks for {what}, which are not simulated"),
                )
                .at(reader.place(count))
                .help(format!("set /YD/{count} to 0 to run the deck without {what}")),
            );
        }
    }
    let head = reader.integer("YDI/IIECFF");
    if head != -2 {
        reader.report(
            Diagnostic::error(
                "scene::couple-restart",
                format!("IIECFF is {head}: couple lists of an earlier run are not taken over"),
            )
            .at(reader.place("YDI/IIECFF"))
            .expected("-2, which starts with an empty list")
            .help("set /YD/YDI/IIECFF to -2: contact is detected anew at the first step"),
        );
    }
}
