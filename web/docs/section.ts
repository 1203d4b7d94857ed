/** What lies below a heading of a document. */
export interface Section {
  /** Of the document: its name and its title. */
  page: string;
  title: string;
  /** The identifier of the heading in its page. */
  id: string;
  heading: string;
  /** Without marks. */
  text: string;
}
