// Files that the page hands out.
import { element } from "../dom";

export function save(name: string, content: Blob): void {
  const address = URL.createObjectURL(content);
  const link = element("a", { attributes: { href: address, download: fileName(name) } });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

function fileName(name: string): string {
  return (
    name
      .replace(/\s+/g, " ")
      .replace(/[^\p{L}\p{N}._ -]+/gu, "_")
      .replace(/^[. ]+/, "")
      .slice(0, 100) || "report"
  );
}

function csvCell(value: string | number | null | undefined): string {
  if (
    value === null ||
    value === undefined ||
    (typeof value === "number" && !Number.isFinite(value))
  )
    return "";
  // A spreadsheet would take a name that begins so for a formula.
  const isFormula = typeof value === "string" && /^[=+@\t-]/.test(value);
  const text = (isFormula ? "'" : "") + String(value);
  return /[",\n\r;]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
}

export function csv(rows: (string | number | null | undefined)[][]): Blob {
  const text = rows.map((row) => row.map(csvCell).join(",")).join("\n");
  return new Blob([text, "\n"], { type: "text/csv" });
}

export function savePicture(name: string, canvas: HTMLCanvasElement): void {
  canvas.toBlob((blob) => {
    if (blob) save(name, blob);
  }, "image/png");
}
