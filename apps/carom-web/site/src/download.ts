// Files to and from the person who uses the page: by the browser's own dialogs, nothing else.

export function save(name: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type: "application/octet-stream" }));
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}

export const stem = (name: string): string => name.replace(/\.[^.]*$/, "");
