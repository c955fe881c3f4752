// pymdownx.arithmatex leaves \(...\) and \[...\] in elements of the class arithmatex.
for (const element of document.querySelectorAll(".arithmatex")) {
  const text = element.textContent.trim();
  const equation = text.slice(2, -2);
  katex.render(equation, element, {displayMode: text.startsWith("\\["), throwOnError: false});
}
