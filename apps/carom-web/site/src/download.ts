// Files to and from the person who uses the page: by the browser's own dialogs, nothing else.

export function save(name: string, what: string | Blob): void {
  const blob = what instanceof Blob ? what : new Blob([what], { type: "application/octet-stream" });
  const address = URL.createObjectURL(blob);
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}

export const stem = (name: string): string => name.replace(/\.[^.]*$/, "");
