//! What a wasm module answers with, declared once: a struct in Rust is a plain object in JavaScript and an interface in TypeScript.

use std::fmt::Write as _;

use heatwalk_contract::{camel, doc, documented};
use proc_macro::TokenStream;
use quote::quote;
use syn::{DeriveInput, Error, Fields, GenericArgument, LitStr, PathArguments, Result, Type};

/// Lets functions of a wasm module give a struct with named fields, one or several or none: plain objects whose properties are
/// its fields in camel case, by `Into<JsValue>`. `#[typescript("...")]` says what the type of a field is in TypeScript, where
/// that of Rust has no equal there.
#[proc_macro_derive(Message, attributes(typescript))]
pub fn message(item: TokenStream) -> TokenStream {
    let item = syn::parse(item).and_then(|item| expanded(&item));
    item.unwrap_or_else(|error| error.into_compile_error().into())
}

fn expanded(item: &DeriveInput) -> Result<TokenStream> {
    let name = &item.ident;
    let fields = match &item.data {
        syn::Data::Struct(item) if matches!(item.fields, Fields::Named(_)) => &item.fields,
        _ => return Err(Error::new_spanned(name, "a message is a struct with named fields")),
    };
    let mut interface = documented(&doc(&item.attrs), "");
    // Writing to a String cannot fail.
    let _ = writeln!(interface, "export interface {name} {{");
    let (mut members, mut keys) = (Vec::new(), Vec::new());
    for field in fields {
        let member = field.ident.as_ref().expect("it is named");
        let key = camel(&member.to_string());
        let stated = field.attrs.iter().find(|attribute| attribute.path().is_ident("typescript"));
        let holds = match stated {
            Some(stated) => stated.parse_args::<LitStr>()?.value(),
            None => typescript(&field.ty)?,
        };
        interface += documented(&doc(&field.attrs), "  ").trim_start_matches('\n');
        let _ = writeln!(interface, "  {key}: {holds};");
        members.push(member);
        keys.push(key);
    }
    interface += "}\n";
    let letters: Vec<u32> = name.to_string().chars().map(u32::from).collect();
    let length = letters.len() as u32;
    Ok(quote! {
        const _: () = {
            use ::wasm_bindgen::JsValue;
            use ::wasm_bindgen::convert::{IntoWasmAbi, OptionIntoWasmAbi, VectorIntoWasmAbi, js_value_vector_into_abi};
            use ::wasm_bindgen::describe::{NAMED_EXTERNREF, VECTOR, WasmDescribe, WasmDescribeVector, inform};

            #[::wasm_bindgen::prelude::wasm_bindgen(typescript_custom_section)]
            const INTERFACE: &str = #interface;

            impl From<#name> for JsValue {
                fn from(message: #name) -> Self {
                    ::heatwalk_bindings::object(&[#((#keys, message.#members.into())),*])
                }
            }

            impl WasmDescribe for #name {
                fn describe() {
                    inform(NAMED_EXTERNREF);
                    inform(#length);
                    #(inform(#letters);)*
                }
            }

            impl IntoWasmAbi for #name {
                type Abi = <JsValue as IntoWasmAbi>::Abi;

                fn into_abi(self) -> Self::Abi {
                    JsValue::from(self).into_abi()
                }
            }

            impl OptionIntoWasmAbi for #name {
                fn none() -> Self::Abi {
                    0
                }
            }

            impl WasmDescribeVector for #name {
                fn describe_vector() {
                    inform(VECTOR);
                    Self::describe();
                }
            }

            impl VectorIntoWasmAbi for #name {
                type Abi = <Box<[JsValue]> as IntoWasmAbi>::Abi;

                fn vector_into_abi(messages: Box<[Self]>) -> Self::Abi {
                    js_value_vector_into_abi(messages)
                }
            }
        };
    }
    .into())
}

/// The type of what `Into<JsValue>` makes of a type.
fn typescript(of: &Type) -> Result<String> {
    let unknown = || Error::new_spanned(of, "its type in TypeScript has to be said");
    let path = match of {
        Type::Path(path) => path,
        Type::Reference(reference) => return typescript(&reference.elem),
        _ => return Err(unknown()),
    };
    let segment = path.path.segments.last().ok_or_else(unknown)?;
    let argument = || match &segment.arguments {
        PathArguments::AngleBracketed(list) => match list.args.first() {
            Some(GenericArgument::Type(argument)) => Ok(argument),
            _ => Err(unknown()),
        },
        _ => Err(unknown()),
    };
    Ok(match segment.ident.to_string().as_str() {
        "bool" => "boolean".to_owned(),
        "str" | "String" => "string".to_owned(),
        "i8" | "i16" | "i32" | "isize" | "u8" | "u16" | "u32" | "usize" | "f32" | "f64" => "number".to_owned(),
        "Option" => format!("{} | undefined", typescript(argument()?)?),
        "Vec" => {
            let held = argument()?;
            match (typescript(held)?.as_str(), quote!(#held).to_string().split_at(1)) {
                ("number", ("f", bits)) => format!("Float{bits}Array"),
                ("number", ("i", bits)) => format!("Int{bits}Array"),
                ("number", (_, bits)) => format!("Uint{bits}Array"),
                (held, _) => format!("{held}[]"),
            }
        }
        name => name.to_owned(),
    })
}
