//! Rules that are the least there is, automatic, or a length, and how they are written.

/// Makes an enum with the variants `Automatic` and `Within` such a rule: `length_rule!(Type, Least = "word", "what the length is");`.
macro_rules! length_rule {
    ($rule:ident, $least:ident = $word:literal, $name:literal) => {
        impl std::fmt::Display for $rule {
            fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self {
                    Self::$least => formatter.write_str($word),
                    Self::Automatic => formatter.write_str("auto"),
                    Self::Within(length) => length.fmt(formatter),
                }
            }
        }

        impl std::str::FromStr for $rule {
            type Err = $crate::error::Error;

            fn from_str(text: &str) -> $crate::error::Result<Self> {
                match text {
                    $word => Ok(Self::$least),
                    "auto" => Ok(Self::Automatic),
                    _ => {
                        let length = text.parse().ok().filter(|length: &f64| length.is_finite() && *length >= 0.0);
                        length.map(Self::Within).ok_or_else(|| $crate::error::Error::BadParameter {
                            name: $name,
                            value: text.to_owned(),
                            range: concat!("auto, ", $word, ", or 0 or more"),
                        })
                    }
                }
            }
        }
    };
}

pub(crate) use length_rule;

#[cfg(test)]
mod tests {
    use crate::bridges::BridgeRule;
    use crate::cracks::WeldRule;

    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    #[test]
    fn rules_are_read_as_they_are_written() {
        for rule in [BridgeRule::Off, BridgeRule::Automatic, BridgeRule::Within(0.0), BridgeRule::Within(0.25)] {
            assert_eq!(rule.to_string().parse(), Ok(rule));
        }
        for rule in [WeldRule::Exact, WeldRule::Automatic, WeldRule::Within(0.0), WeldRule::Within(1e-5)] {
            assert_eq!(rule.to_string().parse(), Ok(rule));
        }
        for text in ["", "-1", "NaN", "inf", "near"] {
            assert!(text.parse::<BridgeRule>().is_err() && text.parse::<WeldRule>().is_err(), "{text}");
        }
        assert!("exact".parse::<BridgeRule>().is_err() && "off".parse::<WeldRule>().is_err());
    }
}
