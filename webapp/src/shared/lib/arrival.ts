import { createContext, useContext } from 'react';

/** Whether the first page is shown. Without a provider it is. */
export const ArrivedContext = createContext(true);

/** What takes the browser long, such as a chart or a scene, starts when the text around it can be read. */
export const useArrived = () => useContext(ArrivedContext);
