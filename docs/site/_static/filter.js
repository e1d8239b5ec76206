// A field above each table of a .filterable: rows whose text has every word that is typed stay.
document.querySelectorAll(".filterable").forEach((box) => {
  const field = document.createElement("input");
  const count = document.createElement("span");
  const rows = [...box.querySelectorAll("tbody tr")];
  field.type = "search";
  field.placeholder = "filter: erratum sign kim";
  field.setAttribute("aria-label", "filter the rows");
  const show = () => {
    const words = field.value.toLowerCase().split(/\s+/);
    rows.forEach((row) => {
      const text = row.textContent.toLowerCase();
      row.hidden = !words.every((word) => text.includes(word));
    });
    count.textContent = ` ${rows.filter((row) => !row.hidden).length} of ${rows.length}`;
  };
  field.addEventListener("input", show);
  box.prepend(field, count);
  show();
});
