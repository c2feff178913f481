window.bookIndex = {"documents": [{"section": "A task", "text": "The hidden answer is that the hammer is heavier than its handle."}]};
