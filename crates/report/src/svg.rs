//! Writes SVG and HTML elements: every name is ours, every value and text is escaped.

use std::fmt::{Display, Write};

/// A number with at most `.1` decimals, without trailing zeros; a number that is not finite becomes 0, since one such
/// token would void a whole path.
#[derive(Clone, Copy)]
pub(crate) struct Rounded(pub f64, pub usize);

impl Display for Rounded {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let value = if self.0.is_finite() { self.0 } else { 0.0 };
        let text = format!("{value:.*}", self.1);
        let text = match text.contains('.') {
            true => text.trim_end_matches('0').trim_end_matches('.'),
            false => &text,
        };
        f.write_str(if text == "-0" { "0" } else { text })
    }
}

/// Text as it may stand in an element or in a quoted attribute of XML and HTML. Characters that XML does not allow
/// become the replacement character.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\t' | '\n' => out.push(c),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

/// Attributes of an element: names of ours and values of any kind.
pub(crate) type Attributes<'a> = &'a [(&'a str, &'a dyn Display)];

/// Builds a document element by element.
#[derive(Default)]
pub(crate) struct Writer {
    out: String,
    open: Vec<&'static str>,
}

impl Writer {
    /// Opens an element that [`Self::close`] ends.
    pub fn open(&mut self, name: &'static str, attributes: Attributes) {
        self.tag(name, attributes);
        self.out.push('>');
        self.open.push(name);
    }

    /// Ends the innermost open element.
    pub fn close(&mut self) {
        if let Some(name) = self.open.pop() {
            self.push(format_args!("</{name}>\n"));
        }
    }

    /// An element without content.
    pub fn empty(&mut self, name: &str, attributes: Attributes) {
        self.tag(name, attributes);
        self.out.push_str("/>\n");
    }

    /// An element that contains text only.
    pub fn text(&mut self, name: &str, attributes: Attributes, text: &str) {
        self.tag(name, attributes);
        self.push(format_args!(">{}</{name}>\n", escape(text)));
    }

    /// Style sheets and finished markup of our own: not escaped.
    pub fn raw(&mut self, markup: &str) {
        self.out.push_str(markup);
    }

    /// Ends all open elements and hands the document out.
    pub fn finish(mut self) -> String {
        while !self.open.is_empty() {
            self.close();
        }
        self.out
    }

    fn tag(&mut self, name: &str, attributes: Attributes) {
        self.push(format_args!("<{name}"));
        for (key, value) in attributes {
            let value = escape(&value.to_string());
            self.push(format_args!(" {key}=\"{value}\""));
        }
    }

    fn push(&mut self, arguments: std::fmt::Arguments) {
        // Writing to a String cannot fail.
        let _ = self.out.write_fmt(arguments);
    }
}
